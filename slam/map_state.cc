// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "cvo_slam/core/error.h"
#include "cvo_slam/slam/map_state_internal.h"

namespace cvo_slam {

std::optional<CorrectedPose> MapState::place_of(std::size_t number) const {
  SE3 T_substitute_keyframe;
  while (const Substitute* const substitute = keyframes.substitute_for(number)) {
    T_substitute_keyframe = substitute->T_substitute_keyframe * T_substitute_keyframe;
    number = substitute->number;
  }
  const PoseGraph& nodes = graph.graph();
  if (!nodes.has_node(node_id(number))) return std::nullopt;
  const std::size_t position = nodes.index_of(node_id(number));
  return CorrectedPose{(graph.pose(position) * T_substitute_keyframe).normalized(),
                       submap_at(position)};
}

void MapState::exchange(SavedState& state) {
  state(keyframes, graph, submaps, gaps, links, contradictions, usual_cos_theta, loaded);
  if (!state.is_reading()) return;
  const auto& nodes = graph.graph().nodes();
  bool is_possible = nodes.size() == keyframes.size() && loaded <= keyframes.size();
  for (std::size_t i = 0; is_possible && i < nodes.size(); ++i) {
    is_possible = nodes[i].id == node_id(keyframes[i].number);
  }
  for (const Gap& gap : gaps) {
    is_possible = is_possible && std::max(gap.from, gap.to) < keyframes.size();
  }
  for (const auto* list : {&links, &contradictions}) {
    for (const SubmapLink& link : *list) {
      is_possible = is_possible && keyframes.has(link.older) && keyframes.has(link.newer);
    }
  }
  if (!is_possible) throw DataError("a saved state does not belong to the keyframes of its map");
}

}  // namespace cvo_slam
