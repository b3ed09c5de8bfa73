// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is known of places that the graph does not connect with the newest frame: images alone say
// where it is, and there may be places that look alike.
#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/information.h"
#include "cvo_slam/slam/keyframe_map_internal.h"

namespace cvo_slam {
namespace {

/// Whether two poses are of one place, however good they are.
bool is_one_place(const SE3& a, const SE3& b) {
  constexpr double kTranslation = 1;  // [m]; look-alikes are further apart
  constexpr double kRotation = 0.5;   // [rad]
  const SE3 motion = a.inverse() * b;
  return motion.translation().norm() < kTranslation && motion.angle() < kRotation;
}

}  // namespace

/// Why a verified place is not to be believed without the graph; empty where it is.
std::string KeyframeMap::find_doubt(const std::vector<LoopMatch>& matches,
                                    std::size_t index) const {
  const RelocalizationOptions& options = options_.loops.relocalization;
  const Verification& best = matches[index].verification;
  if (best.visible_share < options.min_visible_share) {
    return fmt::format(
        "{:.2f} of the features that both should see match; {:.2f} needed where the "
        "graph does not know the way",
        best.visible_share, options.min_visible_share);
  }
  if (best.coverage < options.min_coverage) {
    return fmt::format(
        "{:.2f} of the image cells that both should see match; {:.2f} needed where "
        "the graph does not know the way",
        best.coverage, options.min_coverage);
  }
  if (const LoopMatch* const rival = find_rival(matches, index)) {
    return fmt::format("{} shows as much of it, {:.2f} of the image cells and here {:.2f}",
                       rival->keyframe, rival->verification.coverage, best.coverage);
  }
  return {};
}

/// Another place of the same part of the graph that explains nearly as much of the image. Of
/// look-alikes the number of inliers says little: posters have most features. They cover less.
const LoopMatch* KeyframeMap::find_rival(const std::vector<LoopMatch>& matches,
                                         std::size_t index) const {
  const auto view_of = [this](const LoopMatch& match) -> const KeyframeView& {
    return views_[graph().index_of(node_id(match.keyframe))];
  };
  const Verification& best = matches[index].verification;
  const KeyframeView& view = view_of(matches[index]);
  const double enough = options_.loops.relocalization.rival_share * best.coverage;
  const auto rival = std::find_if(matches.begin(), matches.end(), [&](const LoopMatch& other) {
    const Verification& v = other.verification;
    const KeyframeView& other_view = view_of(other);
    return v.accepted && v.coverage > enough && other_view.part == view.part &&
           !is_one_place(view.T_world_camera * best.T_a_b, other_view.T_world_camera * v.T_a_b);
  });
  return rival == matches.end() ? nullptr : &*rival;
}

/// The registration of the frame that the verifier has as its newest with a place it may be at.
std::optional<KeyframeLink> KeyframeMap::register_lost(const LoopMatch& match,
                                                       LoopCandidate& candidate) {
  const KeyframeView& view = views_[graph().index_of(node_id(match.keyframe))];
  const auto measurement = loop_closer_->verifier.verify(*view.cloud, match.verification.T_a_b,
                                                         nullptr, usual_cos_theta(), candidate);
  if (!measurement) return std::nullopt;
  candidate.accepted = false;
  candidate.reason = "waits for frames that agree";
  return KeyframeLink{match.keyframe, measurement->T_older_newer, measurement->information,
                      candidate.cos_theta};
}

std::optional<FoundPlace> KeyframeMap::relocalize(const RgbdFrame& image, const PointCloud& cloud) {
  if (!loop_closer_) return std::nullopt;
  const auto appearance = loop_closer_->detector.extract(image);
  const auto matches = loop_closer_->detector.relocalize(*appearance);
  std::optional<FoundPlace> found;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    LoopCandidate candidate = candidate_of(matches[i]);
    candidate.relocalization = true;
    candidate.reason = matches[i].verification.reason;
    if (candidate.reason.empty()) candidate.reason = find_doubt(matches, i);
    if (candidate.reason.empty() && found) candidate.reason = "another is found already";
    if (candidate.reason.empty()) {
      loop_closer_->verifier.set_newest(cloud);
      if (const auto link = register_lost(matches[i], candidate)) {
        const KeyframeView& view = views_[graph().index_of(node_id(link->reference))];
        found = {*link, (view.T_world_camera * link->T_reference_keyframe).normalized(), view.part};
      }
    }
    candidates_.push_back(std::move(candidate));
  }
  return found;
}

/// The edge to the keyframe where the first of a segment was recognised to be.
void KeyframeMap::add_place(const KeyframeLink& place, std::size_t frame) {
  optimizer_.add_edge({node_id(place.reference), node_id(frame), place.T_reference_keyframe,
                       edge_information(place.T_reference_keyframe, place.information),
                       EdgeKind::kLoop, true});
  for (LoopCandidate& candidate : candidates_) {
    if (!candidate.relocalization || candidate.from != place.reference || candidate.to != frame) {
      continue;
    }
    candidate.accepted = true;
    candidate.reason.clear();
  }
}

/// Keeps what the newest keyframe says of where another part is, until enough say the same.
void KeyframeMap::link_part(const LoopMatch& match, LoopCandidate& candidate) {
  const std::size_t older = graph().index_of(node_id(match.keyframe));
  const auto measurement = loop_closer_->verifier.verify(
      *views_[older].cloud, match.verification.T_a_b, nullptr, usual_cos_theta(), candidate);
  if (!measurement) return;
  candidate.accepted = false;
  candidate.reason = "of another segment: waits for keyframes that agree";
  part_links_.push_back({older, views_.size() - 1, *measurement, candidates_.size()});
}

/// Joins the newest keyframe's part with another of which enough keyframes say where it is. Answers
/// whether there are new edges.
bool KeyframeMap::join_parts() {
  const int newest = views_.back().part;
  std::map<int, std::vector<PartLink>> links_to;  // parts of the older ones
  for (const PartLink& link : part_links_) {
    const int older = views_[link.older].part;
    if (views_[link.newer].part == newest && older != newest) links_to[older].push_back(link);
  }
  for (const auto& [part, links] : links_to) {
    const PartPlacement placement = place_part(links, views_, options_.loops.relocalization);
    if (!placement.is_certain(options_.loops.relocalization)) continue;
    if (part < newest) {
      move_part(newest, placement.T_world_world);
    } else {
      move_part(part, placement.T_world_world.inverse());
    }
    for (const std::size_t i : placement.agreeing) add_part_link(links[i]);
    update_parts();
    return true;  // of one at a time: what others say may change with it
  }
  return false;
}

void KeyframeMap::add_part_link(const PartLink& link) {
  const SE3& T_older_newer = link.measurement.T_older_newer;
  optimizer_.add_edge({node_id(views_[link.older].frame), node_id(views_[link.newer].frame),
                       T_older_newer, edge_information(T_older_newer, link.measurement.information),
                       EdgeKind::kLoop, true});
  candidates_[link.candidate].accepted = true;
  candidates_[link.candidate].reason.clear();
}

/// A start for the optimisation, which cannot see a part that is metres off for what it is.
void KeyframeMap::move_part(int part, const SE3& T_new_old) {
  for (std::size_t i = 0; i < views_.size(); ++i) {
    if (views_[i].part != part) continue;
    views_[i].T_world_camera = (T_new_old * views_[i].T_world_camera).normalized();
    optimizer_.set_pose(i, views_[i].T_world_camera);
  }
}

void KeyframeMap::update_parts() {
  const std::vector<std::size_t> components = graph().components();
  std::map<std::size_t, int> first_segment;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const auto [place, is_new] = first_segment.emplace(components[i], views_[i].segment);
    if (!is_new) place->second = std::min(place->second, views_[i].segment);
  }
  for (std::size_t i = 0; i < views_.size(); ++i) views_[i].part = first_segment[components[i]];
  std::erase_if(part_links_, [this](const PartLink& link) {
    if (views_[link.older].part != views_[link.newer].part) return false;
    LoopCandidate& candidate = candidates_[link.candidate];
    if (!candidate.accepted) candidate.reason = "most keyframes say that the segment is elsewhere";
    return true;
  });
}

int KeyframeMap::part_of(int segment) const {
  const auto view = std::find_if(views_.begin(), views_.end(),
                                 [segment](const KeyframeView& v) { return v.segment == segment; });
  return view == views_.end() ? segment : view->part;
}

}  // namespace cvo_slam
