// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>

#include "cvo_slam/slam/part_links_internal.h"

namespace cvo_slam {
namespace {

/// The world of the newer ones in that of the older ones, as a link has it.
SE3 worlds_of(const PartLink& link, const std::vector<KeyframeView>& views) {
  return views[link.older].T_world_camera * link.measurement.T_older_newer *
         views[link.newer].T_world_camera.inverse();
}

/// Whether a link says the same as another one, which has the worlds so. It is asked where its own
/// keyframes are: a small angle between the worlds is metres at their origins.
bool agrees(const PartLink& link, const SE3& T_world_world, const std::vector<KeyframeView>& views,
            const RelocalizationOptions& options) {
  const SE3 predicted =
      views[link.older].T_world_camera.inverse() * T_world_world * views[link.newer].T_world_camera;
  const SE3 error = link.measurement.T_older_newer.inverse() * predicted;
  return error.translation().norm() <= options.max_disagreement_translation &&
         error.angle() <= options.max_disagreement_rotation;
}

std::size_t newer_keyframes(const std::vector<std::size_t>& chosen,
                            const std::vector<PartLink>& links) {
  std::set<std::size_t> keyframes;
  for (const std::size_t i : chosen) keyframes.insert(links[i].newer);
  return keyframes.size();
}

/// The most that say the same, among those that are left; the earliest of equal sets.
PartPlacement largest_set(const std::vector<PartLink>& links, const std::vector<std::size_t>& left,
                          const std::vector<KeyframeView>& views,
                          const RelocalizationOptions& options) {
  PartPlacement best;
  for (const std::size_t seed : left) {
    const SE3 T_world_world = worlds_of(links[seed], views);
    std::vector<std::size_t> agreeing;
    std::copy_if(left.begin(), left.end(), std::back_inserter(agreeing),
                 [&](std::size_t i) { return agrees(links[i], T_world_world, views, options); });
    const std::size_t keyframes = newer_keyframes(agreeing, links);
    if (keyframes > best.keyframes) best = {std::move(agreeing), keyframes, 0, T_world_world};
  }
  return best;
}

}  // namespace

bool PartPlacement::is_certain(const RelocalizationOptions& options) const {
  return keyframes >= static_cast<std::size_t>(options.join_keyframes) && 2 * rivals <= keyframes;
}

PartPlacement place_part(const std::vector<PartLink>& links, const std::vector<KeyframeView>& views,
                         const RelocalizationOptions& options) {
  std::vector<std::size_t> left(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) left[i] = i;
  PartPlacement placement = largest_set(links, left, views, options);
  std::erase_if(left, [&](std::size_t i) {
    return std::binary_search(placement.agreeing.begin(), placement.agreeing.end(), i);
  });
  placement.rivals = largest_set(links, left, views, options).keyframes;
  return placement;
}

}  // namespace cvo_slam
