// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures the loops of whole runs: how many of the loops in the final graph are right, how many of
// the returns to a place were noticed, and the error of the trajectory. Prints a row of the table
// of docs/results/place-recognition.md for each sequence.
//   closed_loops [--verbose] sequence...
#include <algorithm>
#include <cstdio>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/bench/visible_overlap.h"
#include "cvo_slam/core/association.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/slam.h"

namespace cvo_slam {
namespace {

/// A keyframe with its true pose.
struct KnownKeyframe {
  RgbdFrame frame;
  SE3 T_world_camera;
};

/// Returns true if a measurement is right: within 5 cm and 3 degrees of the truth.
bool is_correct(const SE3& T_true, const SE3& T_measured) {
  constexpr double kTranslation = 0.05;  // [m]
  constexpr double kRotation = 3 * std::numbers::pi / 180;
  const SE3 error = T_true.inverse() * T_measured;
  return error.translation().norm() <= kTranslation && error.angle() <= kRotation;
}

struct Row {
  std::size_t keyframes = 0;
  std::size_t lost = 0;
  std::size_t candidates = 0;
  std::size_t loops = 0;  // in the final graph
  std::size_t wrong = 0;  // loops of the final graph that are wrong
  std::size_t revisits = 0;
  std::size_t revisits_found = 0;
  std::size_t events = 0;
  std::size_t events_found = 0;
  double ate = 0;  // [m]
};

/// Compares the loops of a run with the true poses of its keyframes.
class Judge {
 public:
  Judge(const Dataset& data, const Slam& slam, const SlamOptions& options, bool verbose)
      : data_(data), slam_(slam), options_(options), verbose_(verbose) {
    for (const Keyframe& keyframe : slam.keyframes()) {
      constexpr double kMaxGap = 0.1;  // [s]
      const auto pose = interpolate_at(data.reference(), keyframe.stamp, kMaxGap);
      if (!pose) continue;
      index_[keyframe.number] = keyframes_.size();
      keyframes_.push_back({data.read(keyframe.number), *pose});
    }
  }

  Row row() {
    Row row;
    row.keyframes = keyframes_.size();
    const Trajectory trajectory = slam_.trajectory();
    row.lost = trajectory.lost.size();
    for (const LoopCandidate& c : slam_.loop_candidates()) {
      row.candidates += c.kind == EdgeKind::kLoop ? 1 : 0;
    }
    judge_edges(row);
    judge_revisits(row);
    row.ate = absolute_trajectory_error(associate(data_.reference(), trajectory.poses))
                  .statistics.translation.rmse;
    return row;
  }

 private:
  [[nodiscard]] std::size_t gap() const {
    return static_cast<std::size_t>(options_.loops.detection.candidates.min_gap);
  }
  [[nodiscard]] SE3 true_motion(std::size_t a, std::size_t b) const {
    return keyframes_[a].T_world_camera.inverse() * keyframes_[b].T_world_camera;
  }

  void judge_edges(Row& row) {
    const PoseGraph graph = slam_.pose_graph();
    for (const PoseGraphEdge& edge : graph.edges()) {
      const auto from = index_.find(static_cast<std::size_t>(edge.from));
      const auto to = index_.find(static_cast<std::size_t>(edge.to));
      if (from == index_.end() || to == index_.end()) continue;
      const bool is_right = is_correct(true_motion(from->second, to->second), edge.T_from_to);
      if (edge.kind != EdgeKind::kOdometry && from->second + gap() < to->second && is_right) {
        noticed_[to->second] = true;
      }
      if (edge.kind != EdgeKind::kLoop) continue;
      ++row.loops;
      row.wrong += is_right ? 0 : 1;
      if (!verbose_) continue;
      const SE3 error = true_motion(from->second, to->second).inverse() * edge.T_from_to;
      fmt::print("  {} {} error {:.3f} m {:.4f} rad{}\n", edge.from, edge.to,
                 error.translation().norm(), error.angle(), is_right ? "" : " WRONG");
    }
  }

  /// Counts the keyframes that share at least half of their view with an earlier one outside the
  /// temporal exclusion. Such keyframes in a row are one event.
  void judge_revisits(Row& row) const {
    constexpr double kOverlap = 0.5;
    constexpr std::size_t kSameEvent = 3;
    std::optional<std::size_t> last;
    bool event_found = false;
    for (std::size_t j = gap() + 1; j < keyframes_.size(); ++j) {
      bool revisits = false;
      for (std::size_t i = 0; i + gap() < j && !revisits; ++i) {
        revisits = mutual_overlap(keyframes_[i].frame, keyframes_[j].frame, true_motion(i, j),
                                  data_.camera()) >= kOverlap;
      }
      if (!revisits) continue;
      if (!last || j > *last + kSameEvent) {
        ++row.events;
        event_found = false;
      }
      last = j;
      ++row.revisits;
      if (!noticed_.contains(j)) continue;
      ++row.revisits_found;
      row.events_found += event_found ? 0 : 1;
      event_found = true;
    }
  }

  const Dataset& data_;
  const Slam& slam_;
  const SlamOptions& options_;
  bool verbose_;
  std::vector<KnownKeyframe> keyframes_;
  std::map<std::size_t, std::size_t> index_;  // by frame
  std::map<std::size_t, bool> noticed_;
};

void print_row(const std::string& sequence, bool verbose) {
  const auto data = open_dataset(sequence);
  SlamOptions options;
  options.loops.enabled = true;
  Slam slam(data->camera(), options);
  for (std::size_t i = 0; i < data->size(); ++i) slam.track(data->read(i));
  slam.finish();
  const Row row = Judge(*data, slam, options, verbose).row();
  fmt::print("| {} | {} | {} | {} | {} | {} | {} of {} | {} of {} | {:.1f} cm |\n", data->name(),
             data->size(), row.lost, row.keyframes, row.candidates,
             fmt::format("{} ({} wrong)", row.loops, row.wrong), row.revisits_found, row.revisits,
             row.events_found, row.events, 100 * row.ate);
  std::fflush(stdout);
}

}  // namespace
}  // namespace cvo_slam

// NOLINTNEXTLINE(bugprone-exception-escape): options that are defined wrongly throw, no others
int main(int argc, char** argv) {
  std::vector<std::string> sequences;
  bool verbose = false;
  CLI::App app("Measures precision and recall of the loops of whole runs");
  app.add_option("sequences", sequences)->required();
  app.add_flag("--verbose", verbose, "Prints a line for each loop");
  CLI11_PARSE(app, argc, argv);
  fmt::print(
      "| sequence | frames | lost | keyframes | candidates | loops in the graph | revisiting "
      "keyframes joined | revisits noticed | ATE |\n|---|---|---|---|---|---|---|---|---|\n");
  return cvo_slam::report_errors([&] {
    for (const std::string& sequence : sequences) cvo_slam::print_row(sequence, verbose);
  });
}
