// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is known of places that the graph does not connect with the newest frame: images alone say
// where it is, and there may be places that look alike.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <fmt/format.h>

#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/slam/keyframe_map_internal.h"
#include "cvo_slam/slam/path_uncertainty_internal.h"

namespace cvo_slam {
namespace {

/// Whether two poses are of one place, however good they are.
bool is_one_place(const SE3& a, const SE3& b) {
  constexpr double kTranslation = 1;  // [m]; look-alikes are further apart
  constexpr double kRotation = 0.5;   // [rad]
  const SE3 motion = a.inverse() * b;
  return motion.translation().norm() < kTranslation && motion.angle() < kRotation;
}

/// Of how far a camera has come that nobody has tracked.
Matrix6 lost_covariance(double seconds, const RelocalizationOptions& options) {
  const double translation = options.lost_speed * seconds;
  const double rotation = options.lost_angular_speed * seconds;
  Matrix6 covariance = Matrix6::Zero();
  covariance.diagonal().head<3>().setConstant(translation * translation);
  covariance.diagonal().tail<3>().setConstant(rotation * rotation);
  return covariance;
}

double largest_rotation(const Matrix6& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(covariance.bottomRightCorner<3, 3>(),
                                                      Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

}  // namespace

/// Where the first keyframe of a segment is if the camera stood still while it was lost, as the
/// tracker has it.
SE3 KeyframeMap::after_gap(const TrackedKeyframe& keyframe) {
  const KeyframeView& last = views_.back();
  const SE3 T_last_keyframe = T_world_newest_tracked_.inverse() * keyframe.T_world_camera;
  constexpr double kShortest = 0.01;  // [s]
  const double seconds = std::max(kShortest, seconds_between(last.stamp, keyframe.stamp));
  const AlignedMatrix6 information =
      AlignedMatrix6(lost_covariance(seconds, options_.loops.relocalization)).inverse();
  gaps_.push_back({node_id(last.frame), node_id(keyframe.frame), T_last_keyframe,
                   edge_information(T_last_keyframe, information)});
  return (last.T_world_camera * T_last_keyframe).normalized();
}

/// What the graph and the gaps between its parts say of a frame that was taken now, as seen from an
/// older keyframe; none where that is next to nothing.
std::optional<PairPrior> KeyframeMap::prior_of_lost(std::size_t older, const Timestamp& now) const {
  PoseGraph graph_and_gaps = graph();
  for (const PoseGraphEdge& gap : gaps_) graph_and_gaps.add_edge(gap);
  const auto covariances = path_covariances(graph_and_gaps, views_.size() - 1);
  if (!covariances[older]) return std::nullopt;
  PairPrior prior = prior_of(older, *covariances[older]);
  const double seconds = std::max(0.0, seconds_between(views_.back().stamp, now));
  prior.covariance += lost_covariance(seconds, options_.loops.relocalization);
  // With more a view from the other side could not be told from this one.
  constexpr double kLargest = 0.6;  // [rad]
  if (largest_rotation(prior.covariance) > kLargest) return std::nullopt;
  return prior;
}

/// Whether the camera can have come to where a match says it is: little moved, however long it was
/// lost, for look-alikes are further apart, or by what is known of its motion.
bool KeyframeMap::is_likely(const LoopMatch& match, const Timestamp& now) const {
  const std::size_t older = graph().index_of(node_id(match.keyframe));
  const SE3 T_older_last = views_[older].T_world_camera.inverse() * views_.back().T_world_camera;
  if (is_one_place(T_older_last, match.verification.T_a_b)) return true;
  const auto prior = prior_of_lost(older, now);
  if (!prior) return false;
  const Eigen::Matrix<double, 6, 1> error =
      (prior->T_older_newer.inverse() * match.verification.T_a_b).log();
  constexpr double kMaxError = 4;  // standard deviations: chi-square's 99 %
  return std::sqrt(error.dot(AlignedMatrix6(prior->covariance).ldlt().solve(error))) <= kMaxError;
}

/// Why a verified place need not be registered; empty where it is to be.
std::string KeyframeMap::find_doubt(const std::vector<LoopMatch>& matches,
                                    std::size_t index) const {
  const double coverage = matches[index].verification.coverage;
  const double needed = options_.loops.relocalization.min_likely_coverage;
  if (coverage < needed) {
    return fmt::format(
        "{:.2f} of the image cells that both should see match; {:.2f} needed where "
        "the graph does not know the way",
        coverage, needed);
  }
  return find_rival_reason(matches, index);
}

/// Why a registered place may be a look-alike; empty where that is ruled out.
std::string KeyframeMap::find_strangeness(const LoopMatch& match, double cos_theta,
                                          const Timestamp& now) const {
  const RelocalizationOptions& options = options_.loops.relocalization;
  const Verification& v = match.verification;
  const double usual = usual_cos_theta();
  const double likeness = 2 * (v.coverage + v.visible_share) + (usual > 0 ? cos_theta / usual : 0);
  if (likeness >= options.min_likeness || is_likely(match, now)) return {};
  return fmt::format("likeness {:.2f}; {:.2f} needed so far from where the camera was lost",
                     likeness, options.min_likeness);
}

std::string KeyframeMap::find_rival_reason(const std::vector<LoopMatch>& matches,
                                           std::size_t index) const {
  const LoopMatch* const rival = find_rival(matches, index);
  if (rival == nullptr) return {};
  return fmt::format("{} shows as much of it, {:.2f} of the image cells and here {:.2f}",
                     rival->keyframe, rival->verification.coverage,
                     matches[index].verification.coverage);
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
std::optional<KeyframeLink> KeyframeMap::register_lost(const LoopMatch& match, const Timestamp& now,
                                                       LoopCandidate& candidate) {
  const KeyframeView& view = views_[graph().index_of(node_id(match.keyframe))];
  const auto measurement = loop_closer_->verifier.verify(*view.cloud, match.verification.T_a_b,
                                                         nullptr, usual_cos_theta(), candidate);
  candidate.accepted = false;
  if (!measurement) return std::nullopt;
  candidate.reason = find_strangeness(match, candidate.cos_theta, now);
  if (!candidate.reason.empty()) return std::nullopt;
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
      if (const auto link = register_lost(matches[i], image.stamp, candidate)) {
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
  candidate.accepted = false;
  if (!measurement) return;
  candidate.reason = find_strangeness(match, candidate.cos_theta, views_.back().stamp);
  if (!candidate.reason.empty()) return;
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
