// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/slam/proximity_internal.h"

namespace cvo_slam {
namespace {

constexpr double kCell = 4;  // [m]: a search visits some hundred cells at a reach of 7 m

std::int32_t cell_along(double x) { return static_cast<std::int32_t>(std::floor(x / kCell)); }

bool is_far_from_all(std::size_t position, const std::vector<NearKeyframe>& chosen,
                     std::size_t min_gap) {
  return std::all_of(chosen.begin(), chosen.end(), [&](const NearKeyframe& other) {
    return std::max(position, other.position) - std::min(position, other.position) >= min_gap;
  });
}

}  // namespace

double mutual_overlap(const CompactCloud& a, const CompactCloud& b, const SE3& T_a_b,
                      const FieldOfView& field_of_view) {
  const double b_in_a = visible_share(b, T_a_b, field_of_view);
  if (b_in_a == 0) return 0;
  return std::min(b_in_a, visible_share(a, T_a_b.inverse(), field_of_view));
}

void ProximityIndex::set(std::size_t position, const Vector3& camera, double reach) {
  const Cell cell = {cell_along(camera.x()), cell_along(camera.y()), cell_along(camera.z())};
  if (position < entries_.size()) {
    Entry& entry = entries_[position];
    entry.camera = camera;
    if (entry.cell == cell) return;
    std::erase(cells_[entry.cell], position);
  } else {
    entries_.resize(position + 1);
  }
  entries_[position] = {camera, reach, cell};
  cells_[cell].push_back(position);
  largest_reach_ = std::max(largest_reach_, reach);
}

void ProximityIndex::remove(std::size_t position) {
  std::erase(cells_[entries_[position].cell], position);
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(position));
  for (auto& [cell, positions] : cells_) {
    for (std::size_t& other : positions) {
      if (other > position) --other;
    }
  }
}

std::vector<std::size_t> ProximityIndex::within_reach_of(std::size_t position) const {
  const Entry& center = entries_[position];
  std::vector<std::size_t> found = within_reach_of(center.camera, center.reach);
  std::erase(found, position);
  return found;
}

std::vector<std::size_t> ProximityIndex::within_reach_of(const Vector3& camera,
                                                         double reach) const {
  const double radius = reach + largest_reach_;
  const auto first = [&](int axis) { return cell_along(camera[axis] - radius); };
  const auto last = [&](int axis) { return cell_along(camera[axis] + radius); };
  std::vector<std::size_t> found;
  for (std::int32_t x = first(0); x <= last(0); ++x) {
    for (std::int32_t y = first(1); y <= last(1); ++y) {
      const auto end = cells_.upper_bound({x, y, last(2)});
      for (auto cell = cells_.lower_bound({x, y, first(2)}); cell != end; ++cell) {
        for (const std::size_t other : cell->second) {
          const Entry& entry = entries_[other];
          if ((entry.camera - camera).norm() <= reach + entry.reach) found.push_back(other);
        }
      }
    }
  }
  std::sort(found.begin(), found.end(), std::greater<>());
  return found;
}

std::vector<NearKeyframe> find_near_keyframes(const MapState& map, const ProximityIndex& index,
                                              const FieldOfView& field_of_view,
                                              const ProximityOptions& options) {
  std::vector<NearKeyframe> chosen;
  std::vector<NearKeyframe> not_recent;
  const std::size_t newest_position = map.keyframes.size() - 1;
  for (const std::size_t position : index.within_reach_of(newest_position)) {
    if (position + 1 >= newest_position) continue;
    if (map.submap_at(position) != map.submap_at(newest_position)) continue;
    const SE3 T_older_newer = map.graph.pose(position).inverse() * map.graph.pose(newest_position);
    const double overlap =
        mutual_overlap(map.keyframes[position].cloud, map.keyframes[newest_position].cloud,
                       T_older_newer, field_of_view);
    if (overlap < options.min_expected_overlap) continue;
    const std::size_t between = newest_position - position - 2;  // the predecessor aside
    const bool is_recent = between < static_cast<std::size_t>(options.recent);
    (is_recent ? chosen : not_recent).push_back({position, overlap});
  }
  std::stable_sort(not_recent.begin(), not_recent.end(),
                   [](const NearKeyframe& a, const NearKeyframe& b) {
                     return a.expected_overlap > b.expected_overlap;
                   });
  const std::size_t most = chosen.size() + static_cast<std::size_t>(options.near);
  for (const NearKeyframe& keyframe : not_recent) {
    if (chosen.size() == most) break;
    if (is_far_from_all(keyframe.position, chosen, static_cast<std::size_t>(options.min_gap))) {
      chosen.push_back(keyframe);
    }
  }
  return chosen;
}

}  // namespace cvo_slam
