// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures relocalisation. A camera with a Kinect's noise walks through a synthetic world, is
// carried to a place that it has seen, then to one that it has not seen, and so on: how often and
// how fast it is found, and whether at the right place. Prints a table of
// docs/results/place-recognition.md.
//   kidnapped_camera [--worlds house,office,room] [--seeds 3] [--trials 5] [--verbose]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/slam/slam.h"
#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sensor.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam {
namespace {

constexpr double kRate = 30;               // frames a second [Hz]
constexpr double kWalk = 3;                // duration of the walk before the camera is carried [s]
constexpr std::size_t kFramesToFind = 10;  // length of a stay at a seen place
constexpr std::size_t kFramesUnseen = 20;  // time enough to join a wrong submap
constexpr double kTranslation = 0.05;      // [m]; a pose with a larger error is wrong
constexpr double kRotation = 3 * std::numbers::pi / 180;

struct KidnapArguments {
  std::vector<std::string> worlds = {"house", "office", "room"};
  int first_seed = 301;  // the vocabulary was trained with other seeds
  int seeds = 3;
  int trials = 5;  // number of stays of each kind
  double speed = 2;
  bool verbose = false;
};

/// Returns a uniform random number in [0, 1).
double draw(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1.0p-53; }

/// A depth image [m] and its pose.
struct DepthView {
  SE3 T_world_camera;
  cv::Mat depth;  // CV_64FC1
};

/// Tells how much two poses in a world see of the same, by an ideal camera of few pixels.
class Surroundings {
 public:
  explicit Surroundings(const synthetic::World& world) : world_(world) {}

  [[nodiscard]] DepthView view(const SE3& T_world_camera) const {
    return {T_world_camera, synthetic::render(world_.scene, camera_.color, T_world_camera).depth};
  }

  /// Returns the share of a's view that b sees or that of b's view that a sees, the smaller one.
  [[nodiscard]] double overlap(const DepthView& a, const DepthView& b) const {
    return std::min(visible_overlap(a, b), visible_overlap(b, a));
  }

 private:
  [[nodiscard]] double visible_overlap(const DepthView& a, const DepthView& b) const {
    const SE3 T_a_b = a.T_world_camera.inverse() * b.T_world_camera;
    int seen = 0;
    for (int v = 0; v < b.depth.rows; ++v) {
      for (int u = 0; u < b.depth.cols; ++u) {
        const Vector3 p = T_a_b * (b.depth.at<double>(v, u) * camera_.color.unproject({u, v}));
        if (p.z() < 0.1) continue;
        const Eigen::Vector2d pixel = camera_.color.project(p);
        if (!camera_.color.contains(pixel)) continue;
        const double there = a.depth.at<double>(static_cast<int>(std::lround(pixel.y())),
                                                static_cast<int>(std::lround(pixel.x())));
        if (std::abs(there - p.z()) < 0.05 * p.z()) ++seen;  // not hidden
      }
    }
    return static_cast<double>(seen) / static_cast<double>(b.depth.total());
  }

  const synthetic::World& world_;
  Camera camera_ = synthetic::synthetic_camera(64, 48);
};

/// A stay of the camera: it moves beside the path of the world, from some time on the path.
struct Stay {
  std::size_t first_frame = 0;
  std::size_t frames = 0;
  double begin = 0;   // time on the path [s]
  SE3 offset;         // from the pose on the path
  bool seen = false;  // true if the camera has seen the place before
};

/// Returns a random offset of up to 0.1 m and 0.1 rad along each axis.
SE3 draw_offset(std::mt19937_64& random) {
  Vector6 tangent;
  for (int i = 0; i < 3; ++i) tangent[i] = 0.2 * (draw(random) - 0.5);
  for (int i = 3; i < 6; ++i) tangent[i] = 0.2 * (draw(random) - 0.5);
  return SE3::exp(tangent);
}

/// The plan of a run: a walk, then stays at seen and unseen places by turns.
class Plan {
 public:
  Plan(const synthetic::World& world, const Surroundings& surroundings, int trials,
       std::uint64_t seed)
      : world_(world), surroundings_(surroundings), random_(seed) {
    stays_.push_back({0, static_cast<std::size_t>(kWalk * kRate), 0, SE3(), true});
    for (double t = 0; t < kWalk; t += 0.2) known_.push_back(surroundings_.view(pose(t)));
    for (int i = 0; i < trials; ++i) {
      add_stay(true);
      add_stay(false);
    }
  }

  [[nodiscard]] const std::vector<Stay>& stays() const { return stays_; }
  [[nodiscard]] std::size_t frames() const {
    return stays_.back().first_frame + stays_.back().frames;
  }

  [[nodiscard]] SE3 T_world_camera(double seconds) const {
    const double frame = std::max(0.0, seconds * kRate + 0.5);
    const auto stay = std::prev(std::upper_bound(
        stays_.begin(), stays_.end(), frame,
        [](double f, const Stay& s) { return f < static_cast<double>(s.first_frame); }));
    return pose(stay->begin + seconds - static_cast<double>(stay->first_frame) / kRate) *
           stay->offset;
  }

 private:
  [[nodiscard]] SE3 pose(double seconds) const { return world_.path.T_world_camera(seconds); }

  void add_stay(bool seen) {
    constexpr int kTries = 300;
    const std::size_t frames = seen ? kFramesToFind : kFramesUnseen;
    const double length = static_cast<double>(frames) / kRate;
    const double last = (seen ? kWalk : world_.path.duration()) - length;
    for (int i = 0; i < kTries; ++i) {
      const Stay stay{this->frames(), frames, last * draw(random_), draw_offset(random_), seen};
      if (!fits(stay, length)) continue;
      stays_.push_back(stay);
      if (!seen) known_.push_back(surroundings_.view(pose(stay.begin) * stay.offset));
      return;
    }
  }

  /// Returns true if the first and the last frame of a stay show what was seen before, or for an
  /// unseen place nothing that was seen before.
  [[nodiscard]] bool fits(const Stay& stay, double length) const {
    for (const double t : {0.0, length}) {
      const DepthView view = surroundings_.view(pose(stay.begin + t) * stay.offset);
      double most = 0;
      for (const DepthView& known : known_)
        most = std::max(most, surroundings_.overlap(known, view));
      constexpr double kSeen = 0.5;
      constexpr double kUnseen = 0.02;
      if (stay.seen ? most < kSeen : most > kUnseen) return false;
    }
    return true;
  }

  const synthetic::World& world_;
  const Surroundings& surroundings_;
  std::mt19937_64 random_;
  std::vector<Stay> stays_;
  std::vector<DepthView> known_;
};

/// Outcome of some stays.
struct Tally {
  int trials = 0;
  int found = 0;             // stays with a right pose
  int wrong = 0;             // stays with a wrong pose in the map of the walk
  std::vector<int> frames;   // number of frames until the camera was found, for each stay
  double largest_error = 0;  // largest error of a right pose [m]

  void operator+=(const Tally& other) {
    trials += other.trials;
    found += other.found;
    wrong += other.wrong;
    frames.insert(frames.end(), other.frames.begin(), other.frames.end());
    largest_error = std::max(largest_error, other.largest_error);
  }
};

struct Tallies {
  Tally seen;
  Tally unseen;
};

/// A run through a world.
class Kidnapping {
 public:
  Kidnapping(const KidnapArguments& arguments, const std::string& world, std::uint32_t seed)
      : arguments_(arguments),
        name_(fmt::format("{} {}", world, seed)),
        world_(synthetic::make_world(world, {.seed = seed, .speed = arguments.speed})),
        surroundings_(world_),
        plan_(world_, surroundings_, arguments.trials, seed),
        sensor_(
            world_.scene, [this](double seconds) { return plan_.T_world_camera(seconds); },
            static_cast<double>(plan_.frames()) / kRate, camera_, sensor_options(), seed),
        slam_(camera_, slam_options()) {}

  Tallies run() {
    Tallies tallies;
    for (const Stay& stay : plan_.stays()) {
      const Tally tally = visit(stay);
      if (stay.first_frame == 0) continue;
      (stay.seen ? tallies.seen : tallies.unseen) += tally;
    }
    return tallies;
  }

 private:
  static synthetic::SensorOptions sensor_options() {
    synthetic::SensorOptions options = synthetic::sensor_preset("kinect");
    options.exposure.time = 0;  // motion blur would take most of the time to render
    return options;
  }

  static SlamOptions slam_options() {
    SlamOptions options;
    options.loops.enabled = true;
    return options;
  }

  [[nodiscard]] RgbdFrame frame(std::size_t index) const {
    constexpr double kDepthDelay = 0.008;  // [s]
    const double seconds = static_cast<double>(index) / kRate;
    synthetic::Capture capture = sensor_.capture(index, {seconds, seconds + kDepthDelay});
    RgbdFrame frame;
    frame.index = index;
    frame.stamp = Timestamp::from_seconds(1000 + seconds);
    frame.depth_stamp = Timestamp::from_seconds(1000 + seconds + kDepthDelay);
    frame.color = capture.color;
    frame.depth = capture.depth;
    return frame;
  }

  Tally visit(const Stay& stay) {
    Tally tally;
    tally.trials = 1;
    for (std::size_t i = 0; i < stay.frames; ++i) {
      const std::size_t index = stay.first_frame + i;
      const FrameRecord record = slam_.track(frame(index));
      if (arguments_.verbose && stay.first_frame > 0) print(record);
      if (record.status == TrackingStatus::kLost || record.submap != 0) continue;
      const SE3 error = error_in_map(record);
      if (error.translation().norm() > kTranslation || error.angle() > kRotation) {
        tally.wrong = 1;
        continue;
      }
      tally.largest_error = std::max(tally.largest_error, error.translation().norm());
      if (tally.found == 1) continue;
      tally.found = 1;
      tally.frames.push_back(static_cast<int>(i) + 1);
    }
    if (arguments_.verbose) print(stay, tally);
    return tally;
  }

  void print(const Stay& stay, const Tally& tally) const {
    fmt::print("{}: frames {} to {} ({}, {:.2f} s): found {} wrong {} after {}\n", name_,
               stay.first_frame, stay.first_frame + stay.frames, stay.seen ? "seen" : "unseen",
               stay.begin, tally.found, tally.wrong, fmt::join(tally.frames, ","));
    for (const LoopCandidate& c : slam_.loop_candidates()) {
      if (c.kind != EdgeKind::kLoop || c.to < stay.first_frame) continue;
      fmt::print("    {} {} inliers {} overlap {:.2f} cos {:.3f} {} {}\n", c.from, c.to, c.inliers,
                 c.overlap, c.cos_theta, c.relocalization ? "lost" : "keyframe",
                 c.accepted ? "accepted" : c.reason);
    }
  }

  [[nodiscard]] SE3 T_world_camera(std::size_t frame) const {
    return plan_.T_world_camera(static_cast<double>(frame) / kRate);
  }

  /// Returns the error of a pose relative to the nearest keyframe of the walk, which leaves out the
  /// drift of the map.
  [[nodiscard]] SE3 error_in_map(const FrameRecord& record) const {
    SE3 nearest;
    double shortest = std::numeric_limits<double>::infinity();
    for (const Keyframe& keyframe : slam_.keyframes()) {
      if (keyframe.number >= plan_.stays()[0].frames) break;
      const SE3 T_true = T_world_camera(keyframe.number).inverse() * T_world_camera(record.index);
      const double distance = T_true.translation().norm() + T_true.angle();
      if (distance >= shortest) continue;
      shortest = distance;
      nearest = T_true.inverse() * keyframe.T_world_camera.inverse() * record.T_world_camera;
    }
    return nearest;
  }

  void print(const FrameRecord& record) const {
    const SE3 error = error_in_map(record);
    fmt::print("  {} submap {} {} error {:.3f} m {:.3f} rad, to {} overlap {:.2f} cos {:.2f} {}\n",
               record.index, record.submap,
               record.status == TrackingStatus::kLost ? "lost" : "tracked",
               error.translation().norm(), error.angle(), record.keyframe,
               record.registration.overlap, record.registration.cos_theta, record.reason);
  }

  const KidnapArguments& arguments_;
  std::string name_;
  Camera camera_ = synthetic::synthetic_camera(640, 480);
  synthetic::World world_;
  Surroundings surroundings_;
  Plan plan_;
  synthetic::Sensor sensor_;
  Slam slam_;
};

int median(std::vector<int> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void print_row(const std::string& name, const Tallies& tallies) {
  const Tally& seen = tallies.seen;
  const Tally& unseen = tallies.unseen;
  fmt::print("| {} | {} | {} | {} | {} | {:.0f} mm | {} | {} |\n", name, seen.trials, seen.found,
             seen.wrong, median(seen.frames), 1000 * seen.largest_error, unseen.trials,
             unseen.wrong);
  std::fflush(stdout);
}

void run(const KidnapArguments& arguments) {
  fmt::print(
      "| world | seen places | found | wrong | frames until found, median | largest error | unseen "
      "places | taken for seen ones |\n|---|---|---|---|---|---|---|---|\n");
  Tallies all;
  for (const std::string& world : arguments.worlds) {
    for (int i = 0; i < arguments.seeds; ++i) {
      const int seed = arguments.first_seed + i;
      const Tallies tallies = Kidnapping(arguments, world, static_cast<std::uint32_t>(seed)).run();
      print_row(fmt::format("`{}`, seed {}", world, seed), tallies);
      all.seen += tallies.seen;
      all.unseen += tallies.unseen;
    }
  }
  print_row("**all**", all);
}

}  // namespace
}  // namespace cvo_slam

// NOLINTNEXTLINE(bugprone-exception-escape): options that are defined wrongly throw, no others
int main(int argc, char** argv) {
  cvo_slam::KidnapArguments arguments;
  CLI::App app("Measures relocalisation: kidnaps a camera");
  app.add_option("--worlds", arguments.worlds, "Names of worlds, or world files")->delimiter(',');
  app.add_option("--seeds", arguments.seeds, "Number of seeds of each world")
      ->capture_default_str();
  app.add_option("--first-seed", arguments.first_seed, "Smallest seed")->capture_default_str();
  app.add_option("--trials", arguments.trials, "Number of stays of each kind in a run")
      ->capture_default_str();
  app.add_option("--speed", arguments.speed, "Factor of the speed of the walk")
      ->capture_default_str();
  app.add_flag("--verbose", arguments.verbose,
               "Prints a line for each stay, frame and loop candidate");
  CLI11_PARSE(app, argc, argv);
  return cvo_slam::report_errors([&] { cvo_slam::run(arguments); });
}
