// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/slam/map_memory_internal.h"
#include "cvo_slam/slam/mapper_internal.h"

namespace cvo_slam {

Mapper::Mapper(const Camera& camera, const SlamOptions& options,
               const std::shared_ptr<const Vocabulary>& vocabulary)
    : camera_(camera),
      field_of_view_(camera.color),
      options_(options),
      noise_{options.noise_translation, options.noise_rotation},
      near_registration_(options.tracker.registration, options.tracker.threads,
                         options.proximity.pair, noise_),
      map_(options.optimizer) {
  if (!options.loops.enabled) return;
  loop_closing_.emplace(camera, options.tracker.registration, options.tracker.threads,
                        options.loops, noise_, vocabulary);
}

CorrectedPose Mapper::add(const KeyframeInput& keyframe) {
  add_keyframe(keyframe);
  const std::size_t newest_position = map_.keyframes.size() - 1;
  bool is_closed = false;
  {
    // Over the edges that there are now: those added below have not moved the poses yet. A search
    // must not outlive the removal of an edge, as by separate_submaps().
    PathSearch paths(map_.graph, newest_position);
    connect_near_keyframes(paths);
    is_closed = close_loops(keyframe, paths);
  }
  separate_submaps();
  is_closed = join_submaps() || is_closed;
  ++keyframes_since_solve_;
  if (is_closed) {
    optimize_all();
  } else if (keyframes_since_solve_ >= options_.optimize_every) {
    optimize(OptimizationScope::kWindow);
  }
  CorrectedPose corrected{map_.graph.pose(newest_position), map_.submap_at(newest_position)};
  cull_keyframes();
  return corrected;
}

/// Adds the node, and the edge to the keyframe that it was tracked against or recognised at.
void Mapper::add_keyframe(const KeyframeInput& keyframe) {
  is_fully_optimized_ = false;
  const auto pose_after = [this](std::size_t reference, const SE3& T_reference_keyframe) {
    const std::size_t position = map_.keyframes.position_of(reference);
    return (map_.graph.pose(position) * T_reference_keyframe).normalized();
  };
  SE3 T_world_camera = keyframe.T_world_camera;
  if (keyframe.odometry) {
    T_world_camera =
        pose_after(keyframe.odometry->reference, keyframe.odometry->T_reference_keyframe);
  } else if (keyframe.recognized) {
    T_world_camera =
        pose_after(keyframe.recognized->keyframe, keyframe.recognized->measurement.T_older_newer);
  } else if (map_.has_own_keyframes()) {
    T_world_camera = start_after_gap(keyframe);
  }
  map_.keyframes.add({keyframe.number, keyframe.stamp, keyframe.tracked_submap,
                      CompactCloud(first_points(*keyframe.cloud, options_.map_points))});
  map_.graph.add_keyframe(keyframe.number, T_world_camera);
  proximity_.set(map_.keyframes.size() - 1, T_world_camera.translation(),
                 map_.keyframes.newest().reach);
  T_world_newest_tracked_ = keyframe.T_world_camera;
  if (const auto& odometry = keyframe.odometry) {
    add_edge(EdgeKind::kOdometry, odometry->reference, keyframe.number,
             {odometry->T_reference_keyframe, noise_.added_to(odometry->covariance)}, std::nullopt);
    map_.usual_cos_theta.sum += odometry->cos_theta;
    ++map_.usual_cos_theta.count;
  } else if (const auto& recognized = keyframe.recognized) {
    add_edge(EdgeKind::kLoop, recognized->keyframe, keyframe.number, recognized->measurement,
             recognized->row);
    accept(recognized->row);
  }
}

/// The pose of the first keyframe of a submap if the camera stood still while it was lost, by the
/// tracker's poses. Keeps the gap.
SE3 Mapper::start_after_gap(const KeyframeInput& keyframe) {
  const std::size_t last_position = map_.keyframes.size() - 1;
  const SE3 T_last_keyframe = T_world_newest_tracked_.inverse() * keyframe.T_world_camera;
  constexpr double kShortest = 0.01;  // [s]
  const double seconds =
      std::max(kShortest, seconds_between(map_.keyframes[last_position].stamp, keyframe.stamp));
  // Gaps say where a lost camera may be.
  if (loop_closing_)
    map_.gaps.push_back(
        {last_position, last_position + 1, T_last_keyframe,
         both_ways(T_last_keyframe, untracked_covariance(seconds, options_.loops.relocalization))});
  return (map_.graph.pose(last_position) * T_last_keyframe).normalized();
}

void Mapper::connect_near_keyframes(PathSearch& paths) {
  const auto near_keyframes =
      find_near_keyframes(map_, proximity_, field_of_view_, options_.proximity);
  if (near_keyframes.empty()) return;
  const std::size_t newest_position = map_.keyframes.size() - 1;
  const std::size_t newer = map_.keyframes.newest().number;
  near_registration_.set_newer(map_.keyframes.newest().cloud.points());
  for (const auto& [older_position, expected_overlap] : near_keyframes) {
    const auto covariance = paths.covariance_to(older_position);
    if (!covariance) continue;
    const PairPrior prior = graph_prior(map_.graph, older_position, newest_position, *covariance);
    const std::size_t older = map_.keyframes[older_position].number;
    const PairVerdict verdict = near_registration_.register_both_ways(
        map_.keyframes[older_position].cloud.points(), prior.T_older_newer, &prior,
        map_.usual_cos_theta.mean());
    const std::size_t row = candidates_.size();  // pushed below
    if (verdict.measurement) {
      add_edge(EdgeKind::kProximity, older, newer, *verdict.measurement, row);
    }
    candidates_.push_back(candidate_row(EdgeKind::kProximity, older, newer, verdict));
    candidates_.back().expected_overlap = expected_overlap;
  }
}

/// Returns true if there is a new edge.
bool Mapper::close_loops(const KeyframeInput& keyframe, PathSearch& paths) {
  if (!loop_closing_ || !keyframe.images) return false;
  const auto matches = loop_closing_->recognize(*keyframe.images, *keyframe.cloud);
  bool is_closed = false;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const LoopVerdict verdict = loop_closing_->judge(matches, i, map_, paths);
    const std::size_t older = matches[i].keyframe;
    const std::size_t row = candidates_.size();  // pushed below
    if (verdict.edge) {
      add_edge(EdgeKind::kLoop, older, keyframe.number, *verdict.edge, row);
      is_closed = true;
    } else if (verdict.unconfirmed) {
      map_.links.push_back({older, keyframe.number, *verdict.unconfirmed, row});
    } else if (verdict.contradiction) {
      map_.contradictions.push_back({older, keyframe.number, *verdict.contradiction, row});
    }
    const bool is_waited_for = verdict.edge || verdict.unconfirmed || verdict.contradiction;
    candidates_.push_back(verdict.row);
    if (!is_waited_for) drop_matches(candidates_.back());
  }
  return is_closed;
}

/// Separates the newest tracked submap from others if more keyframes say that it is elsewhere than
/// have joined it, so that these can join it.
void Mapper::separate_submaps() {
  // Only the submap that is tracked can be separated: the others' contradictions are of no use.
  std::erase_if(map_.contradictions, [this](const SubmapLink& link) {
    return map_.keyframes[map_.keyframes.position_of(link.newer)].tracked_submap !=
           map_.keyframes.newest().tracked_submap;
  });
  const auto separation = find_separation(map_.contradictions, map_, options_.loops.relocalization);
  if (!separation) return;
  for (const std::size_t edge : separation->edges) {
    take_back(edge, fmt::format("taken back: {} keyframes say that its submap is elsewhere",
                                separation->keyframes));
  }
  map_.submaps = submaps_of(map_);
  settle_links();
  map_.links.insert(map_.links.end(), separation->links.begin(), separation->links.end());
  map_.contradictions.clear();
}

/// Joins the newest keyframe's submap with another one if enough keyframes say how. Returns true if
/// there are new edges.
bool Mapper::join_submaps() {
  const auto join = find_join(map_.links, map_, options_.loops.relocalization);
  if (!join) return false;
  // A start for the optimisation, which cannot find its way from metres off.
  for (std::size_t i = 0; i < map_.keyframes.size(); ++i) {
    if (map_.submap_at(i) != join->moved) continue;
    const SE3 T_world_camera = (join->T_new_old * map_.graph.pose(i)).normalized();
    map_.graph.set_pose(i, T_world_camera);
    proximity_.set(i, T_world_camera.translation(), map_.keyframes[i].reach);
  }
  for (const SubmapLink& link : join->links) {
    add_edge(EdgeKind::kLoop, link.older, link.newer, link.measurement, link.row);
    accept(link.row);
  }
  settle_links();
  return true;
}

/// Drops the links within one submap, which are edges now or contradict those that are.
void Mapper::settle_links() {
  std::erase_if(map_.links, [this](const SubmapLink& link) {
    if (map_.submap_at(map_.keyframes.position_of(link.older)) !=
        map_.submap_at(map_.keyframes.position_of(link.newer))) {
      return false;
    }
    LoopCandidate& row = candidates_[link.row];
    if (!row.accepted) {
      row.reason = "most keyframes say that the submap is elsewhere";
      drop_matches(row);
    }
    return true;
  });
}

void Mapper::add_edge(EdgeKind kind, std::size_t older, std::size_t newer,
                      const PairMeasurement& measurement, std::optional<std::size_t> row) {
  map_.graph.add_edge(kind, older, newer, measurement, row);
  map_.submaps.join(map_.keyframes[map_.keyframes.position_of(older)].tracked_submap,
                    map_.keyframes[map_.keyframes.position_of(newer)].tracked_submap);
}

/// Takes the pixels out of a row that was rejected for good, unless they are asked for.
void Mapper::drop_matches(LoopCandidate& row) const {
  if (options_.loops.keep_rejected_matches) return;
  row.pixels.clear();
  row.pixels.shrink_to_fit();
}

/// Marks a candidate that was waiting as an edge.
void Mapper::accept(std::size_t row) {
  candidates_[row].accepted = true;
  candidates_[row].reason.clear();
}

/// Removes an edge and says so in its row.
void Mapper::take_back(std::size_t edge, const std::string& reason) {
  const auto row = map_.graph.remove_edge(edge);
  if (!row) return;
  candidates_[*row].accepted = false;
  candidates_[*row].reason = reason;
  drop_matches(candidates_[*row]);
}

/// Removes the keyframe that has just settled if an older one sees the same, and others that have
/// become redundant since they settled: one is looked at for each that is added. Then those that
/// are missed least, as long as there are more than memory may hold.
void Mapper::cull_keyframes() {
  const KeyframeOptions& limits = options_.tracker.keyframe;
  const auto check = [&](std::size_t position) {
    const auto removal = find_redundancy(map_, position, field_of_view_, limits);
    if (!removal) return false;
    remove_keyframe(*removal);
    ++statistics_.redundant_keyframes;
    return true;
  };
  if (options_.culling.enabled && map_.keyframes.size() > kUnsettledKeyframes) {
    check(map_.keyframes.size() - kUnsettledKeyframes - 1);
    if (next_checked_ >= map_.keyframes.size()) next_checked_ = 0;
    if (!check(next_checked_)) ++next_checked_;
  }
  if (options_.culling.max_memory == 0) return;
  constexpr double kBytesOfMegabyte = 1024.0 * 1024;
  constexpr int kMostDropped = 10;  // a keyframe, or one would take long
  const double most_bytes = options_.culling.max_memory * kBytesOfMegabyte;
  const auto is_too_large = [&] { return static_cast<double>(keyframe_bytes()) > most_bytes; };
  for (int i = 0; i < kMostDropped && is_too_large(); ++i) {
    const auto removal = find_least_missed(map_, limits);
    if (!removal) break;
    remove_keyframe(*removal);
    ++statistics_.dropped_keyframes;
  }
}

void Mapper::remove_keyframe(const Removal& removal) {
  const auto& [position, substitute, edge] = removal;
  const std::size_t number = map_.keyframes[position].number;
  const SE3 T_substitute_keyframe =
      map_.graph.pose(substitute).inverse() * map_.graph.pose(position);
  const std::size_t substitute_number = map_.keyframes[substitute].number;
  map_.graph.replace_keyframe(position, edge);
  map_.keyframes.remove(position, {substitute_number, T_substitute_keyframe});
  proximity_.remove(position);
  if (loop_closing_) loop_closing_->remove(number);
  for (Gap& gap : map_.gaps) {
    if (gap.from > position) --gap.from;
    if (gap.to > position) --gap.to;
  }
  if (position < map_.loaded) --map_.loaded;
  is_fully_optimized_ = false;
  std::set<std::size_t> moved;
  for (const std::size_t i : moved_) {
    if (i != position) moved.insert(i > position ? i - 1 : i);
  }
  moved_ = std::move(moved);
}

std::optional<RecognizedPose> Mapper::relocalize(const RgbdFrame& images, const PointCloud& cloud) {
  if (!loop_closing_) return std::nullopt;
  Relocalization result = cvo_slam::relocalize(images, cloud, map_, *loop_closing_);
  if (result.pose) result.pose->row += candidates_.size();
  for (LoopCandidate& row : result.rows) {
    candidates_.push_back(std::move(row));
    const bool is_waited_for = result.pose && result.pose->row + 1 == candidates_.size();
    if (!is_waited_for) drop_matches(candidates_.back());
  }
  return result.pose;
}

void Mapper::restore(const Map& map) {
  LoopClosing* const loops = loop_closing_ ? &*loop_closing_ : nullptr;
  cvo_slam::restore(map, map_, loops);
  index_keyframes();
}

/// Enters all keyframes where they are now.
void Mapper::index_keyframes() {
  for (std::size_t i = 0; i < map_.keyframes.size(); ++i) {
    proximity_.set(i, map_.graph.pose(i).translation(), map_.keyframes[i].reach);
  }
}

GraphStatistics Mapper::statistics() const {
  GraphStatistics statistics = statistics_;
  statistics.keyframe_bytes = keyframe_bytes();
  return statistics;
}

std::size_t Mapper::keyframe_bytes() const {
  return map_.keyframes.bytes() + (loop_closing_ ? loop_closing_->bytes() : 0);
}

Map Mapper::to_map() const {
  return cvo_slam::to_map(map_, loop_closing_ ? &*loop_closing_ : nullptr, camera_);
}

std::optional<SE3> Mapper::locate(const PointCloud& cloud, const PredictedPose& predicted) {
  if (!localizer_) {
    localizer_.emplace(camera_, options_.tracker.registration, options_.tracker.threads, noise_);
  }
  return localizer_->locate(cloud, predicted, map_, proximity_);
}

void Mapper::optimize_all() {
  if (is_fully_optimized_) return;
  optimize(OptimizationScope::kFull);
  // One at a time: a wrong loop makes right ones fit badly too.
  while (const auto worst = find_worst_loop(graph(), options_.loops.max_residual)) {
    take_back(worst->edge, fmt::format("taken back: {:.1f} standard deviations from the optimised "
                                       "graph",
                                       worst->error));
    map_.submaps = submaps_of(map_);
    settle_links();
    optimize(OptimizationScope::kFull);
  }
  is_fully_optimized_ = true;
}

void Mapper::optimize(OptimizationScope scope) {
  const Summary summary = map_.graph.optimize(scope);
  for (const std::size_t i : map_.graph.moved()) {
    proximity_.set(i, map_.graph.pose(i).translation(), map_.keyframes[i].reach);
    moved_.insert(i);
  }
  keyframes_since_solve_ = 0;
  if (scope == OptimizationScope::kWindow) {
    ++statistics_.window_solves;
    statistics_.window_seconds += summary.seconds;
  } else {
    ++statistics_.full_solves;
    statistics_.full_seconds += summary.seconds;
    statistics_.last_full = summary;
  }
}

}  // namespace cvo_slam
