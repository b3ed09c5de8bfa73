// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/tracker_impl_internal.h"

namespace cvo_slam {
namespace {

bool has_equal_sizes(const PointCloud& cloud) {
  const auto has_size = [&](const auto& values) { return values.size() == cloud.size(); };
  const auto has_size_or_none = [&](const auto& values) {
    return values.empty() || has_size(values);
  };
  return has_size(cloud.y) && has_size(cloud.z) && has_size(cloud.u) && has_size(cloud.v) &&
         std::all_of(cloud.features.begin(), cloud.features.end(), has_size) &&
         has_size_or_none(cloud.ray_noise) && has_size_or_none(cloud.surfaces);
}

}  // namespace

// SavedState finds these by their arguments, which it would not in a namespace without a name.
static void exchange(SavedState& state, SurfacePatch& patch) {
  state(patch.normal, patch.roughness);
}

static void exchange(SavedState& state, PointCloud& cloud) {
  state(cloud.x, cloud.y, cloud.z, cloud.features, cloud.u, cloud.v, cloud.ray_noise,
        cloud.surfaces, cloud.surface_noise);
}

void exchange(SavedState& state, Exposure& exposure) {
  state(exposure.gain, exposure.log_measured);
}

/// All that later frames depend on, and what follows from it.
void Tracker::Impl::exchange(SavedState& state) {
  bool is_pending = pending.has_value();
  state(motion, exposure, policy, usual, keyframe, keyframe_images, keyframe_points,
        last_tracked.images, last_tracked.exposure, is_pending, pending_was_taken, submap,
        lost_in_a_row, first_lost);
  if (!state.is_reading()) return;
  pending.reset();
  if (!keyframe) return;
  if (!check_images(last_tracked.images, camera).empty() ||
      !check_images(keyframe_images, camera).empty() || !has_equal_sizes(keyframe_points)) {
    throw DataError("a saved state has images of another camera, or no points");
  }
  const Exposure last_exposure = last_tracked.exposure;
  last_tracked = selector.prepare(last_tracked.images);
  last_tracked.exposure = last_exposure;
  registration.set_fixed(keyframe_points);
  // It is always the last tracked frame, and its points are those that frames are registered to.
  if (is_pending) {
    pending = {last_tracked.images.index, std::make_shared<const PointCloud>(keyframe_points),
               last_tracked.images};
  }
}

void Tracker::exchange(SavedState& state) { ExclusiveAccess(impl_, "Tracker")->exchange(state); }

}  // namespace cvo_slam
