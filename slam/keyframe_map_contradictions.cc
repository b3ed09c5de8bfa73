// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A segment that was joined at a place that only looked like another one: places that are
// recognised later do not fit the graph, and agree with one another.
#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "cvo_slam/slam/keyframe_map_internal.h"

namespace cvo_slam {

/// Keeps a place that the graph refuses, where it is the graph that may be wrong: the way there
/// leads through another place that was recognised.
void KeyframeMap::keep_contradiction(const std::vector<LoopMatch>& matches, std::size_t index) {
  const std::size_t older = graph().index_of(node_id(matches[index].keyframe));
  if (views_[older].segment == views_.back().segment) return;
  if (!find_doubt(matches, index).empty()) return;
  LoopCandidate unprejudiced;
  const auto measurement =
      loop_closer_->verifier.verify(*views_[older].cloud, matches[index].verification.T_a_b,
                                    nullptr, usual_cos_theta(), unprejudiced);
  if (!measurement) return;
  const Timestamp& now = views_.back().stamp;
  if (!find_strangeness(matches[index], unprejudiced.cos_theta, now).empty()) return;
  contradictions_.push_back({older, views_.size() - 1, *measurement, candidates_.size()});
}

bool KeyframeMap::leads_out_of(const PoseGraphEdge& edge, int segment) const {
  const auto segment_of = [this](NodeId id) { return views_[graph().index_of(id)].segment; };
  return (segment_of(edge.from) == segment) != (segment_of(edge.to) == segment);
}

/// Takes the newest segment off the others where more keyframes say that it is elsewhere than have
/// joined it, so that these can.
void KeyframeMap::take_back_joins() {
  const int segment = views_.back().segment;
  std::vector<PartLink> links;
  std::copy_if(contradictions_.begin(), contradictions_.end(), std::back_inserter(links),
               [&](const PartLink& link) { return views_[link.newer].segment == segment; });
  const RelocalizationOptions& options = options_.loops.relocalization;
  const PartPlacement placement = place_part(links, views_, options);
  if (!placement.is_certain(options)) return;
  std::set<NodeId> joined;  // the newer ones of what holds the segment
  for (const PoseGraphEdge& edge : graph().edges()) {
    if (edge.kind == EdgeKind::kLoop && leads_out_of(edge, segment)) joined.insert(edge.to);
  }
  if (placement.keyframes <= joined.size()) return;
  for (std::size_t i = graph().edges().size(); i-- > 0;) {
    const PoseGraphEdge edge = graph().edges()[i];
    if (edge.kind == EdgeKind::kOdometry || !leads_out_of(edge, segment)) continue;
    optimizer_.remove_edge(i);
    take_back(edge, fmt::format("taken back: {} keyframes say that its segment is elsewhere",
                                placement.keyframes));
  }
  update_parts();
  for (const std::size_t i : placement.agreeing) part_links_.push_back(links[i]);
  contradictions_.clear();
}

}  // namespace cvo_slam
