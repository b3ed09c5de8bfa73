// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"

namespace cvo_slam {
namespace {

using IndexPairs = std::vector<std::pair<std::size_t, std::size_t>>;

void check(const RelativePoseOptions& options) {
  if (!(std::isfinite(options.delta) && options.delta > 0)) {
    throw OptionError(fmt::format("delta {}: must be a positive number", options.delta));
  }
  if (options.unit == DeltaUnit::kFrames && options.delta != std::floor(options.delta)) {
    throw OptionError(fmt::format("delta {}: must be a whole number of frames", options.delta));
  }
  if (!(options.relative_tolerance >= 0) || !(options.time_tolerance >= 0)) {
    throw OptionError("the tolerances of delta must be 0 or more");
  }
}

IndexPairs pairs_by_frames(std::size_t count, double frames, bool all_pairs) {
  IndexPairs pairs;
  if (frames >= static_cast<double>(count)) return pairs;
  const auto delta = static_cast<std::size_t>(frames);
  for (std::size_t i = 0; i + delta < count; i += all_pairs ? 1 : delta) {
    pairs.emplace_back(i, i + delta);
  }
  return pairs;
}

/// Returns the length of the estimate's path from the first match to each match [m].
std::vector<double> accumulated_path(const std::vector<MatchedPose>& matches) {
  std::vector<double> path(matches.size(), 0);
  for (std::size_t i = 1; i < matches.size(); ++i) {
    path[i] = path[i - 1] +
              (matches[i].estimate.translation() - matches[i - 1].estimate.translation()).norm();
  }
  return path;
}

/// Returns the first index behind `from` whose path length is nearest to path[from] + delta.
std::size_t nearest_by_path(const std::vector<double>& path, std::size_t from, double delta) {
  const auto begin = path.begin() + static_cast<std::ptrdiff_t>(from) + 1;
  const auto miss = [&](auto it) { return std::fabs(*it - path[from] - delta); };
  auto best = std::lower_bound(begin, path.end(), path[from] + delta);
  if (best == path.end() || (best != begin && miss(std::prev(best)) <= miss(best))) {
    best = std::lower_bound(begin, path.end(), *std::prev(best));
  }
  return static_cast<std::size_t>(best - path.begin());
}

IndexPairs all_pairs_by_path(const std::vector<double>& path, double delta, double tolerance) {
  IndexPairs pairs;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const std::size_t j = nearest_by_path(path, i, delta);
    if (std::fabs(path[j] - path[i] - delta) <= tolerance) pairs.emplace_back(i, j);
  }
  return pairs;
}

IndexPairs consecutive_pairs_by_path(const std::vector<double>& path, double delta) {
  IndexPairs pairs;
  std::optional<std::size_t> last_cut;
  double path_at_cut = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] - path_at_cut < delta) continue;
    if (last_cut) pairs.emplace_back(*last_cut, i);
    last_cut = i;
    path_at_cut = path[i];
  }
  return pairs;
}

/// Returns the median time from a match to the next [s]; 0 if there are fewer than two.
double usual_step(const std::vector<MatchedPose>& matches) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < matches.size(); ++i) {
    steps.push_back(seconds_between(matches[i - 1].stamp, matches[i].stamp));
  }
  return steps.empty() ? 0 : summarize(steps).median;
}

IndexPairs pairs_by_time(const std::vector<MatchedPose>& matches,
                         const RelativePoseOptions& options) {
  const double longest = options.delta + std::max(options.time_tolerance, usual_step(matches));
  IndexPairs pairs;
  std::size_t j = 0;
  for (std::size_t i = 0; i < matches.size();) {
    const auto elapsed = [&](std::size_t k) {
      return seconds_between(matches[i].stamp, matches[k].stamp);
    };
    while (j < matches.size() && elapsed(j) < options.delta) ++j;
    if (j == matches.size()) break;
    const bool found = elapsed(j) <= longest;
    if (found) pairs.emplace_back(i, j);
    i = found && !options.all_pairs ? j : i + 1;
  }
  return pairs;
}

PoseError error_of(const MatchedPose& from, const MatchedPose& to, RelativeErrorKind kind) {
  const SE3 reference = from.reference.inverse() * to.reference;
  const SE3 estimate = from.estimate.inverse() * to.estimate;
  if (kind == RelativeErrorKind::kCvoPaper) {
    const SE3 error = estimate * reference.inverse();
    return {to.stamp, error.translation().norm(), std::numbers::sqrt2 * error.angle()};
  }
  const SE3 error = reference.inverse() * estimate;
  return {to.stamp, error.translation().norm(), error.angle()};
}

}  // namespace

std::string_view to_string(DeltaUnit unit) {
  switch (unit) {
    case DeltaUnit::kFrames:
      return "frames";
    case DeltaUnit::kMetres:
      return "m";
    case DeltaUnit::kSeconds:
      return "s";
  }
  return "";
}

IndexPairs select_pairs(const std::vector<MatchedPose>& matches,
                        const RelativePoseOptions& options) {
  check(options);
  switch (options.unit) {
    case DeltaUnit::kFrames:
      return pairs_by_frames(matches.size(), options.delta, options.all_pairs);
    case DeltaUnit::kSeconds:
      return pairs_by_time(matches, options);
    case DeltaUnit::kMetres:
      break;
  }
  const auto path = accumulated_path(matches);
  return options.all_pairs
             ? all_pairs_by_path(path, options.delta, options.relative_tolerance * options.delta)
             : consecutive_pairs_by_path(path, options.delta);
}

RelativePoseError relative_pose_error(const std::vector<MatchedPose>& matches,
                                      const RelativePoseOptions& options) {
  RelativePoseError result;
  for (const auto& [i, j] : select_pairs(matches, options)) {
    result.errors.push_back(error_of(matches[i], matches[j], options.kind));
  }
  if (result.errors.empty()) {
    throw DataError(
        fmt::format("no two of the {} matched poses are {} {} apart; take a smaller "
                    "delta",
                    matches.size(), options.delta, to_string(options.unit)));
  }
  result.statistics = summarize(result.errors);
  return result;
}

std::vector<PoseError> find_wrong_poses(const std::vector<MatchedPose>& matches,
                                        const WrongMotion& limits) {
  std::vector<PoseError> wrong;
  const MatchedPose* right = nullptr;
  for (const MatchedPose& match : matches) {
    if (right != nullptr) {
      const PoseError error = error_of(*right, match, RelativeErrorKind::kRelativePose);
      if (error.translation > limits.translation || error.rotation > limits.rotation) {
        wrong.push_back(error);
        continue;
      }
    }
    right = &match;
  }
  return wrong;
}

}  // namespace cvo_slam
