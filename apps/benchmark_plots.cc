// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/benchmark_plots.h"

#include "cvo_slam/apps/evaluation_plots.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/plot/comparison_plot.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {
namespace {

ComparedTrajectory compared(const std::vector<StampedPose>& reference,
                            const ContestantResult& result) {
  const auto& ate = result.evaluation ? result.evaluation->ate : std::nullopt;
  const Similarity alignment = ate ? ate->alignment : Similarity();
  const auto matches = associate(reference, result.poses, {.interpolate = true});
  return {result.name, transformed(alignment, result.poses),
          relative_pose_error(matches, cvo_paper_options()).errors};
}

}  // namespace

Figure benchmark_figure(const Dataset& data, const OdometryBenchmark& benchmark) {
  std::vector<StampedPose> reference;
  std::vector<ComparedTrajectory> estimates;
  for (const ContestantResult& result : benchmark.results) {
    if (!result.built_in || result.poses.empty()) continue;
    if (reference.empty()) reference = reference_during(data.reference(), result.poses);
    estimates.push_back(compared(data.reference(), result));
  }
  if (estimates.empty()) throw DataError("no system of the comparison is built in");
  return comparison_figure(reference, estimates);
}

void write_benchmark_plots(const std::filesystem::path& folder, const Dataset& data,
                           const OdometryBenchmark& benchmark) {
  write_figure(folder / "odometry", benchmark_figure(data, benchmark));
}

}  // namespace cvo_slam
