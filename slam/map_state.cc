// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
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

}  // namespace cvo_slam
