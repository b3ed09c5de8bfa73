// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/slam/loop_closing_internal.h"
#include "cvo_slam/slam/map_state_internal.h"

namespace cvo_slam {

/// Returns the map as a value that can be written to files. `loops` is null where places are not
/// recognised. Links between submaps that wait for others to agree are left out.
[[nodiscard]] Map to_map(const MapState& state, const LoopClosing* loops, const Camera& camera);

/// Returns a keyframe as the store has it. Throws DataError if its points are damaged.
[[nodiscard]] StoredKeyframe to_stored_keyframe(const KeyframeMemory& keyframe);

/// Adds the keyframes and edges of a map to a state without any. Throws DataError if the map has no
/// memory, or its parts do not belong together.
void restore(const Map& map, MapState& state, LoopClosing* loops);

}  // namespace cvo_slam
