// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/slam/slam.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/slam/slam_impl_internal.h"

namespace cvo_slam {
namespace {

SlamOptions checked(SlamOptions options) {
  describe(options).check();
  check_consistency(options.tracker);
  int& restart_frames = options.tracker.lost.restart_frames;
  restart_frames = std::max(restart_frames, options.loops.relocalization.frames + 1);
  return options;
}

Keyframe keyframe_at(const MapState& map, std::size_t position) {
  const StoredKeyframe& keyframe = map.keyframes[position];
  return {keyframe.number, keyframe.stamp, map.submap_at(position), map.graph.pose(position)};
}

std::vector<Keyframe> moved_keyframes(Mapper& mapper) {
  std::vector<Keyframe> moved;
  for (const std::size_t position : mapper.take_moved()) {
    moved.push_back(keyframe_at(mapper.map(), position));
  }
  return moved;
}

/// Calls a function if there is one, and keeps what it throws unless something was thrown before.
template <typename Function, typename Value>
void notify(const Function& function, const Value& value, std::exception_ptr& thrown) {
  if (!function) return;
  try {
    function(value);
  } catch (...) {
    if (!thrown) thrown = std::current_exception();
  }
}

}  // namespace

Slam::Impl::Impl(const Camera& camera, const SlamOptions& options_in,
                 const std::shared_ptr<const Vocabulary>& vocabulary)
    : options(checked(options_in)),
      depth_offset(camera.depth_offset.value_or(0)),
      tracker(camera, options.tracker),
      consensus(options.loops.relocalization.frames, options.tracker.lost.max_speed,
                options.tracker.lost.max_angular_speed),
      mapper(camera, options, vocabulary),
      jobs(options.schedule) {
  if (auto* const appearances = mapper.appearances()) {
    start.emplace(camera, options.loops.detection.verification, *appearances);
  }
}

FrameRecord Slam::Impl::track(RgbdFrame frame) {
  frame.index += first_number;
  if (!history.empty() && frame.index <= history.newest().frame) {
    throw DataError(
        fmt::format("frame index {} is not above that of the frame before, {}; number the frames "
                    "in ascending order",
                    frame.index - first_number, history.newest().frame - first_number));
  }
  const StartFinder find_start = [this](const RgbdFrame& reference, const SE3& T_world_reference,
                                        const RgbdFrame& image) {
    return start->find(reference, T_world_reference, image);
  };
  auto [tracked, keyframe] = tracker.track(frame, start ? find_start : StartFinder());
  tracked.submap += first_submap;
  const bool extends_map = map_use != MapUse::kLocalize;
  // submit() reads last_tracked_record, that of the frame before this one: replaced only below.
  if (keyframe) keep_keyframe(*keyframe);
  if (tracked.status == TrackingStatus::kLost) {
    is_located = false;
    if (options.loops.enabled) tracked = relocalize(frame, tracked);
  } else if (extends_map) {
    consensus.clear();
  } else {
    localize(frame, tracked);
  }
  if (tracked.status == TrackingStatus::kTracked) {
    if (start && tracked.submap != last_tracked_record.submap) start->clear();
    last_tracked_record = tracked;
  }
  FrameRecord answer = in_map(tracked);
  if (map_use) {
    answer.localized = answer.status == TrackingStatus::kTracked && answer.submap < first_submap &&
                       (extends_map || is_located);
  }
  history.add({tracked.index, tracked.stamp, tracked.status, tracked.reason, tracked.submap,
               tracked.keyframe, tracked.registration.T_fixed_moving, answer.T_world_camera,
               answer.submap});
  answer.index -= first_number;
  if (answer.keyframe >= first_number) answer.keyframe -= first_number;
  if (answer.promoted_keyframe) *answer.promoted_keyframe -= first_number;
  return answer;
}

FrameRecord Slam::Impl::track_and_notify(const RgbdFrame& frame) {
  FrameRecord record = track(frame);
  std::exception_ptr thrown;
  notify_of_corrections(thrown);
  notify(observer.frame, record, thrown);
  if (thrown) std::rethrow_exception(thrown);
  return record;
}

void Slam::Impl::notify_of_corrections(std::exception_ptr& thrown) {
  for (const auto& keyframes : std::exchange(moved, {})) {
    notify(observer.correction, keyframes, thrown);
  }
}

/// Finds out where a tracked camera is in the map that is not extended: at each keyframe as long as
/// that is known, at each frame as long as it is not.
void Slam::Impl::localize(const RgbdFrame& frame, const FrameRecord& tracked) {
  const auto set_located = [&](const SE3& T_map_camera) {
    is_located = true;
    T_map_last_keyframe = T_map_camera;
    path_since_located = 0;
    consensus.clear();
  };
  const auto correction = corrections.find(tracked.submap);
  if (correction != corrections.end() && !tracked.keyframe_reason.empty()) {
    const FrameRecord expected = in_map(tracked);
    const SE3 T_last_now = T_map_last_keyframe.inverse() * expected.T_world_camera;
    T_map_last_keyframe = expected.T_world_camera;
    path_since_located += T_last_now.translation().norm();
    is_located = false;
    if (const auto pose =
            mapper.locate(tracker.select_keyframe_points(),
                          {expected.T_world_camera, expected.submap, path_since_located})) {
      correction->second.T_corrected_tracked = *pose * tracked.T_world_camera.inverse();
      set_located(*pose);
    }
  }
  if (is_located || !options.loops.enabled) return;
  const auto pose = mapper.relocalize(frame, tracker.select_keyframe_points());
  if (!pose || !consensus.add(frame.stamp, history.seconds_until(frame.stamp), *pose)) return;
  corrections[tracked.submap] = {pose->submap,
                                 pose->T_world_camera * tracked.T_world_camera.inverse()};
  set_located(pose->T_world_camera);
}

/// Continues at a lost frame if enough frames in a row show keyframes that agree on where it is.
FrameRecord Slam::Impl::relocalize(const RgbdFrame& frame, const FrameRecord& lost) {
  const PointCloud cloud = tracker.select_keyframe_points();
  if (cloud.size() == 0) return lost;
  // resume() would drop it.
  if (const auto keyframe = tracker.take_keyframe()) keep_keyframe(*keyframe);
  jobs.wait_until_left(0);  // for one thread at a time, and the same map in every schedule
  const auto pose = mapper.relocalize(frame, cloud);
  if (!pose || !consensus.add(frame.stamp, history.seconds_until(frame.stamp), *pose)) return lost;
  FrameRecord record = tracker.resume(pose->T_world_camera);
  if (record.status == TrackingStatus::kLost) return lost;
  record.submap += first_submap;
  record.features_asked = lost.features_asked;
  consensus.clear();
  recognized = pose;
  T_map_last_keyframe = pose->T_world_camera;
  path_since_located = 0;
  is_located = true;
  // The tracker goes on in the map's own world.
  corrections[record.submap] = {pose->submap, SE3()};
  return record;
}

/// Takes a keyframe that is final, which is always the frame that was tracked last.
void Slam::Impl::keep_keyframe(const TrackerKeyframe& keyframe) {
  if (start) start->add(keyframe.images, last_tracked_record.T_world_camera);
  if (map_use != MapUse::kLocalize) submit(keyframe);
}

/// Hands a keyframe to the mapper, which is always the frame that was tracked last, and applies
/// what the map has learnt from earlier ones.
void Slam::Impl::submit(const TrackerKeyframe& keyframe) {
  const FrameRecord& record = last_tracked_record;
  KeyframeInput input;
  input.number = record.index;
  input.stamp = record.stamp;
  input.tracked_submap = record.submap;
  input.T_world_camera = record.T_world_camera;
  input.cloud = keyframe.cloud;
  if (record.keyframe != record.index) {
    const RegistrationResult& result = record.registration;
    input.odometry = {record.keyframe, result.T_fixed_moving, result.covariance, result.cos_theta};
  }
  input.recognized = std::exchange(recognized, std::nullopt);
  if (options.loops.enabled) input.images = keyframe.images;
  history.add_keyframe(input.number);
  submitted.push_back({record.submap, record.T_world_camera, std::make_shared<MapUpdate>()});
  jobs.submit([this, update = submitted.back().update, input = std::move(input),
               is_observed = static_cast<bool>(observer.correction)] {
    update->newest = mapper.add(input);
    if (is_observed) update->moved = moved_keyframes(mapper);
  });
  apply_corrections(static_cast<std::size_t>(options.correction_delay));
}

/// Waits until at most `left` keyframes are in work, and takes over what the map says of the newest
/// of the others.
void Slam::Impl::apply_corrections(std::size_t left) {
  if (submitted.size() <= left) return;
  jobs.wait_until_left(left);
  const SubmittedKeyframe& newest_done = submitted[submitted.size() - left - 1];
  corrections[newest_done.tracked_submap] = {
      newest_done.update->newest.submap,
      newest_done.update->newest.T_world_camera * newest_done.T_world_camera_tracked.inverse()};
  for (std::size_t i = 0; i + left < submitted.size(); ++i) {
    auto& keyframes = submitted[i].update->moved;
    if (!keyframes.empty()) moved.push_back(std::move(keyframes));
  }
  submitted.erase(submitted.begin(), submitted.end() - static_cast<std::ptrdiff_t>(left));
}

/// A tracked frame where the map has its submap.
FrameRecord Slam::Impl::in_map(FrameRecord record) const {
  const auto correction = corrections.find(record.submap);
  if (record.status == TrackingStatus::kLost || correction == corrections.end()) return record;
  const auto& [submap, T_corrected_tracked] = correction->second;
  record.submap = submap;
  record.T_world_camera = (T_corrected_tracked * record.T_world_camera).normalized();
  return record;
}

void Slam::Impl::finish() {
  if (map_use == MapUse::kLocalize) return;
  if (const auto keyframe = tracker.take_keyframe()) keep_keyframe(*keyframe);
  apply_corrections(0);
  mapper.optimize_all();
  if (observer.correction) {
    auto keyframes = moved_keyframes(mapper);
    if (!keyframes.empty()) moved.push_back(std::move(keyframes));
  }
  std::exception_ptr thrown;
  notify_of_corrections(thrown);
  if (thrown) std::rethrow_exception(thrown);
}

Slam::Slam(const Camera& camera, const SlamOptions& options,
           const std::shared_ptr<const Vocabulary>& vocabulary)
    : impl_(std::make_unique<Impl>(
          camera, options,
          options.loops.enabled && !vocabulary ? builtin_vocabulary() : vocabulary)) {}

Slam::Slam(const Map& map, const SlamOptions& options, MapUse use,
           const std::shared_ptr<const Vocabulary>& vocabulary)
    : Slam(map.memory ? map.memory->camera : Camera(), options, vocabulary) {
  impl_->load(map, use);
}

Slam::~Slam() = default;
Slam::Slam(Slam&&) noexcept = default;
Slam& Slam::operator=(Slam&&) noexcept = default;

FrameRecord Slam::track(RgbdFrame frame, const std::vector<DepthImage>& depths) {
  if (depths.empty()) throw DataError("track() needs a depth image to choose from");
  const double offset = ExclusiveAccess(impl_, "Slam")->depth_offset;
  const auto nearest =
      std::min_element(depths.begin(), depths.end(), [&](const DepthImage& a, const DepthImage& b) {
        const auto distance = [&](const DepthImage& image) {
          return std::fabs(seconds_between(frame.stamp, image.stamp) + offset);
        };
        return std::pair(distance(a), a.stamp) < std::pair(distance(b), b.stamp);
      });
  frame.depth = nearest->depth;
  frame.depth_stamp = nearest->stamp;
  return track(frame);
}

FrameRecord Slam::track(const RgbdFrame& frame) {
  return ExclusiveAccess(impl_, "Slam")->track_and_notify(frame);
}

void Slam::finish() { ExclusiveAccess(impl_, "Slam")->finish(); }

std::size_t Slam::next_index() const {
  const ExclusiveAccess impl(impl_, "Slam");
  return impl->history.empty() ? 0 : impl->history.newest().frame + 1 - impl->first_number;
}

void Slam::observe(SlamObserver observer) {
  ExclusiveAccess(impl_, "Slam")->observer = std::move(observer);
}

Trajectory Slam::trajectory(TrajectoryView view) const {
  const ExclusiveAccess impl(impl_, "Slam");
  if (view == TrajectoryView::kOnline || impl->map_use == MapUse::kLocalize) {
    return online_trajectory(impl->history, impl->first_submap);
  }
  return final_trajectory(impl->history, impl->finished_map(), impl->first_submap);
}

PoseGraph Slam::pose_graph() const {
  const ExclusiveAccess impl(impl_, "Slam");
  return impl->finished_map().graph.graph();
}

std::vector<Keyframe> Slam::keyframes() const {
  const ExclusiveAccess impl(impl_, "Slam");
  const MapState& map = impl->finished_map();
  std::vector<Keyframe> keyframes;
  for (std::size_t i = 0; i < map.keyframes.size(); ++i) {
    keyframes.push_back(keyframe_at(map, i));
  }
  return keyframes;
}

Map Slam::map(MapContent content) const { return ExclusiveAccess(impl_, "Slam")->map(content); }

std::vector<LoopCandidate> Slam::loop_candidates() const {
  const ExclusiveAccess impl(impl_, "Slam");
  impl->jobs.wait_until_left(0);
  return impl->mapper.candidates();
}

GraphStatistics Slam::statistics() const {
  const ExclusiveAccess impl(impl_, "Slam");
  impl->jobs.wait_until_left(0);
  return impl->mapper.statistics();
}

}  // namespace cvo_slam
