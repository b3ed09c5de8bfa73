// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>
#include <vector>

#include "cvo_slam/core/error.h"
#include "cvo_slam/slam/map_memory_internal.h"
#include "cvo_slam/slam/mapper_internal.h"

namespace cvo_slam {

// SavedState finds these by their arguments, which it would not in a namespace without a name.
static void exchange(SavedState& state, PixelPair& pair) {
  state(pair.a_u, pair.a_v, pair.b_u, pair.b_v);
}

static void exchange(SavedState& state, LoopCandidate& row) {
  state(row.kind, row.from, row.to, row.relocalization, row.score, row.normalized_score,
        row.inliers, row.pixels, row.expected_overlap, row.overlap, row.cos_theta,
        row.round_trip_translation, row.round_trip_rotation, row.correction_translation,
        row.correction_rotation, row.error, row.accepted, row.reason);
}

static void exchange(SavedState& state, GraphStatistics& statistics) {
  // Memory is counted anew. Times, and the last optimisation of the whole graph, are of the object
  // that spent them.
  state(statistics.window_solves, statistics.full_solves, statistics.redundant_keyframes,
        statistics.dropped_keyframes);
}

void Mapper::exchange(SavedState& state, const Map& map) {
  const bool recognizes = loop_closing_.has_value();
  bool recognized = recognizes;
  state(recognized);
  if (recognized != recognizes) {
    throw DataError(
        "the map was saved with another value of loops.enabled; go on with the options it had");
  }
  // Files round them to their decimals.
  std::vector<Timestamp> stamps;
  for (std::size_t i = 0; i < map_.keyframes.size(); ++i) {
    stamps.push_back(map_.keyframes[i].stamp);
  }
  state(stamps);
  if (state.is_reading()) {
    if (stamps.size() != map.memory->keyframes.size()) {
      throw DataError("a saved state does not belong to the keyframes of its map");
    }
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      StoredKeyframe keyframe = to_stored_keyframe(map.memory->keyframes[i]);
      keyframe.stamp = stamps[i];
      map_.keyframes.add(std::move(keyframe));
    }
  }
  if (loop_closing_) {
    if (state.is_reading() && map.memory->vocabulary != loop_closing_->vocabulary_checksum()) {
      throw DataError("the map was saved with another vocabulary; go on with the one it had");
    }
    loop_closing_->exchange(state, map.memory->keyframes);
  }
  state(map_, candidates_, statistics_, T_world_newest_tracked_, keyframes_since_solve_,
        next_checked_, is_fully_optimized_);
  if (!state.is_reading()) return;
  const auto has_row = [this](const SubmapLink& link) { return link.row < candidates_.size(); };
  if (!std::all_of(map_.links.begin(), map_.links.end(), has_row) ||
      !std::all_of(map_.contradictions.begin(), map_.contradictions.end(), has_row) ||
      !map_.graph.has_rows_below(candidates_.size())) {
    throw DataError("a saved state has no row for one of its edges");
  }
  index_keyframes();
}

}  // namespace cvo_slam
