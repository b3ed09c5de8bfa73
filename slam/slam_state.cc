// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/slam/slam_impl_internal.h"

namespace cvo_slam {
namespace {

/// Rises with every change of what a class writes.
constexpr int kSessionFormat = 2;

}  // namespace

/// Takes over a map before the first frame.
void Slam::Impl::load(const Map& map, MapUse use) {
  if (use == MapUse::kResume) {
    if (!map.memory || map.memory->session.empty()) {
      throw DataError("the map was saved without its session; use Slam::map(MapContent::kSession)");
    }
    SavedState state(map.memory->session);
    exchange(state, map);
    return state.expect_end();
  }
  mapper.restore(map);
  map_use = use;
  for (const KeyframeMemory& keyframe : map.memory->keyframes) {
    first_number = std::max(first_number, keyframe.number + 1);
    first_submap = std::max(first_submap, keyframe.submap + 1);
  }
}

Map Slam::Impl::map(MapContent content) {
  jobs.wait_until_left(0);
  Map map = mapper.to_map();
  if (content == MapContent::kSession) {
    SavedState state;
    exchange(state, map);
    map.memory->session = state.bytes();
  }
  return map;
}

/// All that later frames depend on besides the map, or `map` and that. No job may be in work.
void Slam::Impl::exchange(SavedState& state, const Map& map) {
  int format = kSessionFormat;
  state(format);
  if (format != kSessionFormat) {
    throw DataError(
        fmt::format("the session of the map has format {}, and this program reads {}; "
                    "go on from the map without it",
                    format, kSessionFormat));
  }
  RegistrationResult& last = last_tracked_record.registration;
  state(tracker, history, consensus, recognized, map_use, first_number, first_submap,
        T_map_last_keyframe, path_since_located, is_located, submitted, corrections,
        last_tracked_record.index, last_tracked_record.stamp, last_tracked_record.keyframe,
        last_tracked_record.submap, last_tracked_record.T_world_camera, last.T_fixed_moving,
        last.covariance, last.cos_theta);
  if (start) state(*start);
  mapper.exchange(state, map);
  const bool has_row = !recognized || recognized->row < mapper.candidates().size();
  if (!has_row || !history.is_consistent()) {
    throw DataError("a saved state does not belong to the frames of its session");
  }
}

}  // namespace cvo_slam
