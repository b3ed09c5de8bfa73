// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "cvo_slam/slam/proximity_internal.h"
#include "cvo_slam/slam/view_overlap_internal.h"

namespace cvo_slam {
namespace {

double expected_overlap(const KeyframeView& a, const KeyframeView& b, const PinholeCamera& camera) {
  return mutual_overlap(*a.cloud, *b.cloud, a.T_world_camera.inverse() * b.T_world_camera, camera);
}

bool is_far_from_all(std::size_t index, const std::vector<NearView>& chosen, std::size_t min_gap) {
  return std::all_of(chosen.begin(), chosen.end(), [&](const NearView& other) {
    return std::max(index, other.index) - std::min(index, other.index) >= min_gap;
  });
}

}  // namespace

std::vector<NearView> find_near_views(const std::vector<KeyframeView>& views,
                                      const PinholeCamera& camera,
                                      const ProximityOptions& options) {
  std::vector<NearView> chosen;
  std::vector<NearView> older;
  const KeyframeView& newest = views.back();
  const std::size_t before_predecessor = views.size() < 2 ? 0 : views.size() - 2;
  const auto recent = static_cast<std::size_t>(options.recent);
  for (std::size_t back = 0; back < before_predecessor; ++back) {
    const std::size_t i = before_predecessor - 1 - back;
    if (views[i].part != newest.part) continue;
    const double overlap = expected_overlap(views[i], newest, camera);
    if (overlap >= options.min_expected_overlap) {
      (back < recent ? chosen : older).push_back({i, overlap});
    }
  }
  std::stable_sort(older.begin(), older.end(), [](const NearView& a, const NearView& b) {
    return a.expected_overlap > b.expected_overlap;
  });
  const std::size_t most = chosen.size() + static_cast<std::size_t>(options.near);
  for (const NearView& view : older) {
    if (chosen.size() == most) break;
    if (is_far_from_all(view.index, chosen, static_cast<std::size_t>(options.min_gap))) {
      chosen.push_back(view);
    }
  }
  return chosen;
}

}  // namespace cvo_slam
