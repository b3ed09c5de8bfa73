// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/slam/map_memory_internal.h"

namespace cvo_slam {

Map to_map(const MapState& state, const LoopClosing* loops, const Camera& camera) {
  Map map;
  map.graph = state.graph.graph();
  MapMemory& memory = map.memory.emplace();
  memory.camera = camera;
  memory.cos_theta_sum = state.usual_cos_theta.sum;
  memory.cos_theta_count = state.usual_cos_theta.count;
  if (loops != nullptr) memory.vocabulary = loops->vocabulary_checksum();
  for (std::size_t i = 0; i < state.keyframes.size(); ++i) {
    const StoredKeyframe& keyframe = state.keyframes[i];
    map.keyframes.push_back({keyframe.stamp, state.graph.pose(i)});
    memory.keyframes.push_back(
        {keyframe.number, keyframe.stamp, keyframe.tracked_submap, keyframe.cloud.to_bytes(),
         loops == nullptr ? std::string() : loops->features_of(keyframe.number)});
  }
  return map;
}

StoredKeyframe to_stored_keyframe(const KeyframeMemory& keyframe) {
  return {keyframe.number, keyframe.stamp, keyframe.submap,
          CompactCloud::from_bytes(keyframe.points)};
}

void restore(const Map& map, MapState& state, LoopClosing* loops) {
  if (!map.memory) {
    throw DataError(
        "this map only serves pictures: it has no points and features of its keyframes; make one "
        "with `cvo_slam run --save-map` or Slam::map()");
  }
  const auto& nodes = map.graph.nodes();
  const auto& keyframes = map.memory->keyframes;
  if (nodes.size() != keyframes.size()) {
    throw DataError(fmt::format("the map has {} keyframes, and {} nodes in its graph",
                                keyframes.size(), nodes.size()));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const KeyframeMemory& keyframe = keyframes[i];
    if (nodes[i].id != node_id(keyframe.number)) {
      throw DataError(fmt::format("node {} of the map's graph is {}, and keyframe {} is {}", i,
                                  nodes[i].id, i, keyframe.number));
    }
    if (loops != nullptr && keyframe.features.empty()) {
      throw DataError(
          "the map was made without place recognition, so that nothing can be recognised in it; "
          "make it with loops.enabled (mode slam), or switch that off");
    }
    state.keyframes.add(to_stored_keyframe(keyframe));
    state.graph.add_keyframe(keyframe.number, nodes[i].T_world_node);
    if (loops != nullptr) loops->restore(keyframe.number, keyframe.features);
  }
  for (const PoseGraphEdge& edge : map.graph.edges()) state.graph.restore_edge(edge);
  state.loaded = state.keyframes.size();
  state.submaps = submaps_of(state);
  state.usual_cos_theta = {map.memory->cos_theta_sum, map.memory->cos_theta_count};
}

}  // namespace cvo_slam
