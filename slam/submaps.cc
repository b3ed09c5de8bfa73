// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "cvo_slam/slam/map_state_internal.h"
#include "cvo_slam/slam/submaps_internal.h"

namespace cvo_slam {
namespace {

const SE3& pose_of(std::size_t number, const MapState& map) {
  return map.graph.pose(map.keyframes.position_of(number));
}

/// The newer keyframe's world in that of the older one, as a link has it.
SE3 world_in_world(const SubmapLink& link, const MapState& map) {
  return pose_of(link.older, map) * link.measurement.T_older_newer *
         pose_of(link.newer, map).inverse();
}

/// True if a link agrees with a relation of the worlds. The comparison is made where its own
/// keyframes are: a small angle between the worlds is metres at their origins.
bool agrees(const SubmapLink& link, const SE3& T_world_world, const MapState& map,
            const RelocalizationOptions& options) {
  const SE3 predicted =
      pose_of(link.older, map).inverse() * T_world_world * pose_of(link.newer, map);
  const SE3 error = link.measurement.T_older_newer.inverse() * predicted;
  return error.translation().norm() <= options.max_disagreement_translation &&
         error.angle() <= options.max_disagreement_rotation;
}

/// A set of links that agree.
struct Consensus {
  std::vector<std::size_t> links;  // indices, ascending
  std::size_t keyframes = 0;
  SE3 T_world_world;
};

std::size_t newer_keyframes(const std::vector<std::size_t>& chosen,
                            const std::vector<SubmapLink>& links) {
  std::set<std::size_t> keyframes;
  for (const std::size_t i : chosen) keyframes.insert(links[i].newer);
  return keyframes.size();
}

/// The largest set of links that agree, among those that are left; the earliest of equal sets.
Consensus largest_consensus(const std::vector<SubmapLink>& links,
                            const std::vector<std::size_t>& left, const MapState& map,
                            const RelocalizationOptions& options) {
  Consensus best;
  for (const std::size_t seed : left) {
    const SE3 T_world_world = world_in_world(links[seed], map);
    std::vector<std::size_t> agreeing;
    std::copy_if(left.begin(), left.end(), std::back_inserter(agreeing),
                 [&](std::size_t i) { return agrees(links[i], T_world_world, map, options); });
    const std::size_t keyframes = newer_keyframes(agreeing, links);
    if (keyframes > best.keyframes) best = {std::move(agreeing), keyframes, T_world_world};
  }
  return best;
}

/// True if an edge leads out of a tracked submap.
bool leads_out_of(const std::pair<std::size_t, std::size_t>& ends, int tracked_submap,
                  const KeyframeStore& keyframes) {
  return (keyframes[ends.first].tracked_submap == tracked_submap) !=
         (keyframes[ends.second].tracked_submap == tracked_submap);
}

}  // namespace

int Submaps::name_of(int tracked_submap) const {
  const auto name = names_.find(tracked_submap);
  return name == names_.end() ? tracked_submap : name->second;
}

void Submaps::join(int a, int b) {
  const auto [first, second] = std::minmax({name_of(a), name_of(b)});
  if (first == second) return;
  for (auto& [submap, name] : names_) {
    if (name == second) name = first;
  }
  names_[second] = first;
}

Submaps submaps_of(const MapState& map) {
  Submaps submaps;
  for (const auto& [a, b] : map.graph.graph().ends()) {
    submaps.join(map.keyframes[a].tracked_submap, map.keyframes[b].tracked_submap);
  }
  return submaps;
}

bool SubmapPlacement::is_certain(const RelocalizationOptions& options) const {
  return keyframes >= static_cast<std::size_t>(options.join_keyframes) && 2 * rivals <= keyframes;
}

SubmapPlacement place_submap(const std::vector<SubmapLink>& links, const MapState& map,
                             const RelocalizationOptions& options) {
  std::vector<std::size_t> left(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) left[i] = i;
  const Consensus best = largest_consensus(links, left, map, options);
  std::erase_if(left, [&](std::size_t i) {
    return std::binary_search(best.links.begin(), best.links.end(), i);
  });
  SubmapPlacement placement;
  for (const std::size_t i : best.links) placement.agreeing.push_back(links[i]);
  placement.keyframes = best.keyframes;
  placement.rivals = largest_consensus(links, left, map, options).keyframes;
  placement.T_world_world = best.T_world_world;
  return placement;
}

std::optional<SubmapJoin> find_join(const std::vector<SubmapLink>& links, const MapState& map,
                                    const RelocalizationOptions& options) {
  const auto submap_of = [&map](std::size_t number) {
    return map.submap_at(map.keyframes.position_of(number));
  };
  const int newest_submap = map.submap_at(map.keyframes.size() - 1);
  std::map<int, std::vector<SubmapLink>> links_to;  // by the older ones' submap
  for (const SubmapLink& link : links) {
    const int older_submap = submap_of(link.older);
    if (submap_of(link.newer) != newest_submap || older_submap == newest_submap) continue;
    links_to[older_submap].push_back(link);
  }
  for (const auto& [submap, links_to_it] : links_to) {
    const SubmapPlacement placement = place_submap(links_to_it, map, options);
    if (!placement.is_certain(options)) continue;
    if (submap < newest_submap) {
      return SubmapJoin{newest_submap, placement.T_world_world, placement.agreeing};
    }
    return SubmapJoin{submap, placement.T_world_world.inverse(), placement.agreeing};
  }
  return std::nullopt;
}

std::optional<SubmapSeparation> find_separation(const std::vector<SubmapLink>& contradictions,
                                                const MapState& map,
                                                const RelocalizationOptions& options) {
  const int submap = map.keyframes.newest().tracked_submap;
  std::vector<SubmapLink> links;
  std::copy_if(contradictions.begin(), contradictions.end(), std::back_inserter(links),
               [&](const SubmapLink& link) {
                 return map.keyframes[map.keyframes.position_of(link.newer)].tracked_submap ==
                        submap;
               });
  const SubmapPlacement placement = place_submap(links, map, options);
  if (!placement.is_certain(options)) return std::nullopt;
  const PoseGraph& graph = map.graph.graph();
  std::set<NodeId> joined;  // newer ends of the loops that hold the submap
  SubmapSeparation separation{{}, placement.keyframes, placement.agreeing};
  for (std::size_t i = graph.edges().size(); i-- > 0;) {
    const PoseGraphEdge& edge = graph.edges()[i];
    if (!leads_out_of(graph.ends()[i], submap, map.keyframes)) continue;
    if (edge.kind == EdgeKind::kLoop) joined.insert(edge.to);
    if (edge.kind != EdgeKind::kOdometry) separation.edges.push_back(i);
  }
  if (placement.keyframes <= joined.size()) return std::nullopt;
  return separation;
}

}  // namespace cvo_slam
