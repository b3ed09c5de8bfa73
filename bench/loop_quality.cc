// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures place recognition without a pose graph: precision and recall of the loop detector's
// candidates and of its verified loops, on a sequence with known poses. Prints the figures of
// docs/results/place-recognition.md.
//   loop_quality <sequence> [--step 15] [--first a] [--last b] [--vocabulary file] [--all-pairs]
//                [--register] [--set key=value]... [--pictures folder] [--verbose]
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/apps/argument_text.h"
#include "cvo_slam/apps/loop_pictures.h"
#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/bench/visible_overlap.h"
#include "cvo_slam/core/association.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/loop/loop_detector.h"
#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {
namespace {

struct QualityArguments {
  std::string sequence;
  std::string vocabulary;
  std::string pictures;
  std::vector<std::string> settings;
  std::size_t step = 15;
  std::size_t first = 0;
  std::size_t last = 1000000000;
  bool all_pairs = false;
  bool registration = false;
  bool verbose = false;
};

/// A keyframe with its true pose.
struct KnownKeyframe {
  RgbdFrame frame;
  SE3 T_world_camera;
  std::shared_ptr<const Appearance> appearance;
};

/// A pair of keyframes and the detector's verdict.
struct JudgedPair {
  std::size_t older = 0;
  std::size_t newer = 0;
  double overlap = 0;
  double translation = 0;  // error [m]
  double rotation = 0;     // error [rad]
  LoopMatch match;
  RegistrationResult refined;  // with --register

  [[nodiscard]] bool is_correct() const {
    constexpr double kTranslation = 0.05;  // [m]
    constexpr double kRotation = 0.0524;   // 3 degrees
    return translation <= kTranslation && rotation <= kRotation;
  }
};

/// Runs the detector over a sequence and compares its answers with the truth.
class Quality {
 public:
  explicit Quality(const QualityArguments& arguments)
      : arguments_(arguments), data_(open_dataset(arguments.sequence)), options_(parse_options()) {
    std::shared_ptr<const Vocabulary> vocabulary;
    if (!arguments.vocabulary.empty()) {
      vocabulary = std::make_shared<const Vocabulary>(read_vocabulary(arguments.vocabulary));
    }
    detector_.emplace(data_->camera(), options_, vocabulary);
  }

  void run() {
    read_keyframes();
    find_revisits();
    if (arguments_.all_pairs) {
      verify_all_pairs();
    } else {
      detect();
    }
    print();
  }

 private:
  LoopOptions parse_options() {
    LoopOptions options;
    const OptionSet set = describe(options);
    for (const auto& setting : arguments_.settings) {
      apply_setting(set, setting, "candidates.min_gap=20");
    }
    return options;
  }

  void read_keyframes() {
    const std::size_t end = std::min(data_->size(), arguments_.last + 1);
    constexpr double kMaxGap = 0.1;  // [s]
    for (std::size_t i = arguments_.first; i < end; i += arguments_.step) {
      const auto pose = interpolate_at(data_->reference(), data_->stamp(i), kMaxGap);
      if (!pose) continue;
      KnownKeyframe keyframe{data_->read(i), *pose, nullptr};
      keyframe.appearance = detector_->extract(keyframe.frame);
      features_ += keyframe.appearance->features.size();
      for (const auto& point : keyframe.appearance->features.points)
        with_depth_ += point.has_depth() ? 1 : 0;
      keyframes_.push_back(std::move(keyframe));
    }
  }

  /// Finds the pairs outside the temporal exclusion that share at least half of their views.
  void find_revisits() {
    const auto gap = static_cast<std::size_t>(options_.candidates.min_gap);
    for (std::size_t j = gap; j < keyframes_.size(); ++j) {
      for (std::size_t i = 0; i + gap < j; ++i) {
        if (overlap_of(i, j) >= 0.5) revisits_[j].push_back(i);
      }
    }
  }

  [[nodiscard]] double overlap_of(std::size_t i, std::size_t j) const {
    const SE3 T_i_j = keyframes_[i].T_world_camera.inverse() * keyframes_[j].T_world_camera;
    return mutual_overlap(keyframes_[i].frame, keyframes_[j].frame, T_i_j, data_->camera());
  }

  [[nodiscard]] JudgedPair judge(std::size_t older, std::size_t newer, LoopMatch match) const {
    const SE3 truth = keyframes_[older].T_world_camera.inverse() * keyframes_[newer].T_world_camera;
    SE3 T_older_newer = match.verification.T_a_b;
    RegistrationResult refined;
    if (arguments_.registration && match.verification.accepted) {
      refined = register_pair(older, newer, T_older_newer);
      if (refined.status != RegistrationStatus::kFailed) T_older_newer = refined.T_fixed_moving;
    }
    const SE3 error = truth.inverse() * T_older_newer;
    const double shared = overlap_of(older, newer);
    return {older,
            newer,
            shared,
            error.translation().norm(),
            error.angle(),
            std::move(match),
            std::move(refined)};
  }

  /// Registers a loop by CVO with as many points as the tracker takes.
  [[nodiscard]] RegistrationResult register_pair(std::size_t older, std::size_t newer,
                                                 const SE3& T_older_newer) const {
    constexpr int kFixed = 6000;
    constexpr int kMoving = 1500;
    return align(select_points(keyframes_[older].frame, data_->camera(), kFixed),
                 select_points(keyframes_[newer].frame, data_->camera(), kMoving), T_older_newer);
  }

  void detect() {
    std::map<std::size_t, std::size_t> index_of;  // by id
    for (std::size_t j = 0; j < keyframes_.size(); ++j) {
      index_of[keyframes_[j].appearance->id] = j;
      for (LoopMatch& match : detector_->find_loops(*keyframes_[j].appearance)) {
        const std::size_t older = index_of[match.keyframe];
        judged_.push_back(judge(older, j, std::move(match)));
      }
      detector_->add(keyframes_[j].appearance);
    }
  }

  void verify_all_pairs() {
    const LoopVerifier verifier(data_->camera(), options_.verification);
    const auto gap = static_cast<std::size_t>(options_.candidates.min_gap);
    for (std::size_t j = gap; j < keyframes_.size(); ++j) {
      for (std::size_t i = 0; i + gap < j; ++i) {
        LoopMatch match;
        match.score =
            bag_score(keyframes_[i].appearance->words.bag, keyframes_[j].appearance->words.bag);
        match.verification = verifier.verify(*keyframes_[i].appearance, *keyframes_[j].appearance);
        judged_.push_back(judge(i, j, std::move(match)));
      }
    }
  }

  /// How many of the revisiting keyframes had a candidate, and were found; those in a row are one
  /// event.
  struct Revisits {
    std::size_t reached = 0;
    std::size_t closed = 0;
    std::size_t events = 0;
    std::size_t events_closed = 0;
  };

  [[nodiscard]] Revisits count_revisits(const std::map<std::size_t, bool>& candidate_of,
                                        const std::map<std::size_t, bool>& found) const {
    Revisits count;
    std::size_t last = 0;
    bool last_closed = false;
    for (const auto& [newer, older] : revisits_) {
      count.reached += candidate_of.contains(newer) ? 1 : 0;
      count.closed += found.contains(newer) ? 1 : 0;
      if (count.events == 0 || newer > last + 3) {
        ++count.events;
        last_closed = false;
      }
      if (found.contains(newer) && !last_closed) {
        ++count.events_closed;
        last_closed = true;
      }
      last = newer;
    }
    return count;
  }

  void print() const {
    std::size_t seeing = 0;
    std::size_t accepted = 0;
    std::size_t correct = 0;
    std::map<std::size_t, bool> candidate_of;
    std::map<std::size_t, bool> found;
    for (const JudgedPair& judged : judged_) {
      seeing += judged.overlap > 0.1 ? 1 : 0;
      if (judged.overlap > 0.1) candidate_of[judged.newer] = true;
      if (judged.match.verification.accepted) {
        ++accepted;
        correct += judged.is_correct() ? 1 : 0;
        if (judged.is_correct()) found[judged.newer] = true;
        if (!judged.is_correct()) draw(judged);
      }
      const bool wrong = judged.match.verification.accepted && !judged.is_correct();
      if (arguments_.verbose || wrong) print(judged);
    }
    const Revisits revisits = count_revisits(candidate_of, found);
    const auto n = static_cast<double>(std::max<std::size_t>(1, keyframes_.size()));
    fmt::print(
        "{}: {} keyframes, {:.0f} features ({:.0f} with depth); candidates {} of which {} see "
        "something of the same; verified {}, correct {}; revisiting keyframes {}: candidate {}, "
        "found {}; events {}, found {}\n",
        data_->name(), keyframes_.size(), static_cast<double>(features_) / n,
        static_cast<double>(with_depth_) / n, judged_.size(), seeing, accepted, correct,
        revisits_.size(), revisits.reached, revisits.closed, revisits.events,
        revisits.events_closed);
  }

  static void print(const JudgedPair& judged) {
    const Verification& v = judged.match.verification;
    fmt::print(
        "{:4} {:4} overlap {:.2f} score {:.3f} {:.2f} matches {} inliers {} visible "
        "{:.2f} cover {:.2f} error {:.3f} m {:.4f} rad {} {}\n",
        judged.older, judged.newer, judged.overlap, judged.match.score,
        judged.match.normalized_score, v.matches, v.inliers, v.inlier_share, v.coverage,
        judged.translation, judged.rotation,
        v.accepted ? (judged.is_correct() ? "ACCEPTED" : "FALSE") : "rejected:", v.reason);
    if (judged.refined.status == RegistrationStatus::kFailed) return;
    fmt::print("          CVO: overlap {:.2f} cos_theta {:.3f}\n", judged.refined.overlap,
               judged.refined.cos_theta);
  }

  void draw(const JudgedPair& judged) const {
    if (arguments_.pictures.empty()) return;
    constexpr int kWidth = 1296;  // width of the picture [px]: two images of 640, not scaled
    const cv::Mat both =
        draw_matches(keyframes_[judged.older].frame.color, keyframes_[judged.newer].frame.color,
                     judged.match.verification.pixels, kWidth);
    make_folder(arguments_.pictures);
    cv::imwrite(fmt::format("{}/{}_{}_{}.png", arguments_.pictures, data_->name(), judged.older,
                            judged.newer),
                both);
  }

  QualityArguments arguments_;
  std::unique_ptr<Dataset> data_;
  LoopOptions options_;
  std::optional<LoopDetector> detector_;
  std::vector<KnownKeyframe> keyframes_;
  std::map<std::size_t, std::vector<std::size_t>> revisits_;  // older keyframes by the newer one
  std::vector<JudgedPair> judged_;
  std::size_t features_ = 0;
  std::size_t with_depth_ = 0;
};

}  // namespace
}  // namespace cvo_slam

// NOLINTNEXTLINE(bugprone-exception-escape): options that are defined wrongly throw, no others
int main(int argc, char** argv) {
  cvo_slam::QualityArguments arguments;
  CLI::App app("Measures precision and recall of the loop detector");
  app.add_option("sequence", arguments.sequence)->required();
  app.add_option("--step", arguments.step, "Number of frames from a keyframe to the next");
  app.add_option("--first", arguments.first, "First frame");
  app.add_option("--last", arguments.last, "Last frame");
  app.add_option("--vocabulary", arguments.vocabulary,
                 "Vocabulary file in place of the built-in vocabulary");
  app.add_option("--set", arguments.settings, "Sets an option: key=value")->allow_extra_args(false);
  app.add_option("--pictures", arguments.pictures, "Folder for pictures of the false loops");
  app.add_flag("--all-pairs", arguments.all_pairs, "Verifies every pair, whatever its words");
  app.add_flag("--register", arguments.registration, "Refines verified loops by CVO");
  app.add_flag("--verbose", arguments.verbose, "Prints a line for each candidate");
  CLI11_PARSE(app, argc, argv);
  return cvo_slam::report_errors([&] { cvo_slam::Quality(arguments).run(); });
}
