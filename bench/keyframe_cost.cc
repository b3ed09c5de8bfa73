// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What adding a keyframe to a map costs while the map grows: a row for each size. Nothing but the
// solver and the search for common words in the index of keyframes may grow with the map.
//   keyframe_cost [--sizes 100,1000,10000] [--odometry-only | --no-loops]
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/bench/synthetic_keyframes.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/slam/mapper_internal.h"

namespace cvo_slam {
namespace {

struct CostArguments {
  std::vector<std::size_t> sizes = {100, 1000, 10000};
  bool odometry_only = false;
  bool no_loops = false;
};

/// A map that keyframes are added to, and the clock beside it.
class GrowingMap {
 public:
  explicit GrowingMap(const SlamOptions& options) : map_(SyntheticKeyframes::camera(), options) {}

  /// Adds the next keyframe. Returns the CPU time of that [s]; none if the solver was at work in
  /// it.
  std::optional<double> add() {
    const KeyframeInput keyframe = make_keyframe();
    const int solves = this->solves();
    const std::clock_t start = std::clock();
    map_.add(keyframe);
    const auto ticks = static_cast<double>(std::clock() - start);
    ++size_;
    if (this->solves() > solves) return std::nullopt;
    return ticks / CLOCKS_PER_SEC;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t edges() const { return map_.graph().edges().size(); }
  /// Wall time of all optimisations so far [s].
  [[nodiscard]] double solver_seconds() const {
    return map_.statistics().window_seconds + map_.statistics().full_seconds;
  }

 private:
  [[nodiscard]] int solves() const {
    return map_.statistics().window_solves + map_.statistics().full_solves;
  }

  [[nodiscard]] KeyframeInput make_keyframe() const {
    KeyframeInput keyframe;
    const RgbdFrame images = SyntheticKeyframes::frame(size_);
    keyframe.number = size_;
    keyframe.stamp = images.stamp;
    keyframe.T_world_camera = SyntheticKeyframes::T_world_camera(size_);
    keyframe.cloud = SyntheticKeyframes::cloud(images);
    keyframe.images = images;
    if (size_ == 0) return keyframe;
    constexpr double kVariance = 1e-6;  // [m^2, rad^2]: 1 mm and 1 mrad
    constexpr double kCosTheta = 0.5;
    const SE3 T_world_last = SyntheticKeyframes::T_world_camera(size_ - 1);
    keyframe.odometry = {size_ - 1, T_world_last.inverse() * keyframe.T_world_camera,
                         kVariance * Matrix6::Identity(), kCosTheta};
    return keyframe;
  }

  Mapper map_;
  std::size_t size_ = 0;
};

/// Means and the largest of the last keyframes before a size.
void print_row(GrowingMap& map, std::size_t size) {
  constexpr std::size_t kMeasured = 90;
  while (map.size() + kMeasured < size) map.add();
  const double solver = map.solver_seconds();
  std::vector<double> seconds;
  const std::size_t first = map.size();
  while (map.size() < size) {
    if (const auto time = map.add()) seconds.push_back(*time);
  }
  if (seconds.empty()) return;
  const auto count = static_cast<double>(seconds.size());
  std::sort(seconds.begin(), seconds.end());
  double sum = 0;
  for (const double value : seconds) sum += value;
  fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} |\n", size, 1000 * sum / count,
             1000 * seconds[seconds.size() / 2], 1000 * seconds.back(),
             1000 * (map.solver_seconds() - solver) / static_cast<double>(size - first),
             static_cast<double>(map.edges()) / static_cast<double>(map.size()));
  std::fflush(stdout);
}

void run(const CostArguments& arguments) {
  SlamOptions options;
  options.loops.enabled = !arguments.odometry_only && !arguments.no_loops;
  if (arguments.odometry_only) options.proximity.recent = options.proximity.near = 0;
  fmt::print(
      "| keyframes | adding one without the solver, mean [ms] | median [ms] | largest [ms] | "
      "solver, mean [ms] | edges a keyframe |\n|---|---|---|---|---|---|\n");
  GrowingMap map(options);
  for (const std::size_t size : arguments.sizes) print_row(map, size);
}

}  // namespace
}  // namespace cvo_slam

// NOLINTNEXTLINE(bugprone-exception-escape): options that are defined wrongly throw, no others
int main(int argc, char** argv) {
  cvo_slam::CostArguments arguments;
  CLI::App app("Measures what adding a keyframe to a map costs");
  app.add_option("--sizes", arguments.sizes, "Ascending sizes of the map [keyframes]")
      ->delimiter(',');
  app.add_flag("--odometry-only", arguments.odometry_only,
               "Neither registers a keyframe to earlier ones nor recognises places");
  app.add_flag("--no-loops", arguments.no_loops,
               "Does not recognise keyframes by their images: no features, no word query");
  CLI11_PARSE(app, argc, argv);
  return cvo_slam::report_errors([&] { cvo_slam::run(arguments); });
}
