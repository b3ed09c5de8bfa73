// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/slam/slam.h"

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/slam/final_trajectory_internal.h"
#include "cvo_slam/slam/job_queue_internal.h"
#include "cvo_slam/slam/mapper_internal.h"

namespace cvo_slam {
namespace {

SlamOptions checked(SlamOptions options) {
  describe(options).check();
  check_consistency(options.tracker);
  return options;
}

/// A keyframe handed to the mapper, done or not, whose correction is not applied yet.
struct SubmittedKeyframe {
  int tracked_submap = 0;
  SE3 T_world_camera_tracked;
  std::shared_ptr<CorrectedPose> pose_in_map;  // written by the job
};

/// Where the map has a tracked submap.
struct Correction {
  int submap = 0;
  SE3 T_corrected_tracked;
};

}  // namespace

struct Slam::Impl {
  Impl(const Camera& camera, const SlamOptions& options_in,
       const std::shared_ptr<const Vocabulary>& vocabulary)
      : options(checked(options_in)),
        tracker(camera, options.tracker),
        consensus(options.loops.relocalization.frames, options.tracker.lost.max_speed,
                  options.tracker.lost.max_angular_speed),
        mapper(camera, options, vocabulary),
        jobs(options.schedule) {}

  SlamOptions options;
  Tracker tracker;
  FrameHistory history;
  FrameRecord last_tracked_record;           // of the last tracked frame, as the tracker answered
  PoseConsensus consensus;                   // of the frames since tracking was lost
  std::optional<RecognizedPose> recognized;  // of the newest keyframe, before the mapper has it
  std::deque<SubmittedKeyframe> submitted;   // in ascending order
  std::map<int, Correction> corrections;     // by tracked submap
  Mapper mapper;
  JobQueue jobs;  // the last member: its thread ends before what it works on

  FrameRecord track(const RgbdFrame& frame);
  [[nodiscard]] FrameRecord relocalize(const RgbdFrame& frame, const FrameRecord& lost);
  void submit(const TrackerKeyframe& keyframe);
  void apply_corrections(std::size_t left);
  [[nodiscard]] FrameRecord in_map(FrameRecord record) const;
  void finish();
};

FrameRecord Slam::Impl::track(const RgbdFrame& frame) {
  if (!history.empty() && frame.index <= history.newest().frame) {
    throw DataError(
        fmt::format("frame index {} is not above that of the frame before, {}; number the frames "
                    "in ascending order",
                    frame.index, history.newest().frame));
  }
  auto [tracked, keyframe] = tracker.track(frame);
  // The keyframe that has become final is the frame tracked before this one: submit() reads
  // last_tracked_record, so that is replaced only below.
  if (keyframe) submit(*keyframe);
  if (tracked.status == TrackingStatus::kTracked) {
    consensus.clear();
  } else if (options.loops.enabled) {
    tracked = relocalize(frame, tracked);
  }
  if (tracked.status == TrackingStatus::kTracked) last_tracked_record = tracked;
  const FrameRecord answer = in_map(tracked);
  history.add({tracked.index, tracked.stamp, tracked.status, tracked.reason, tracked.submap,
               tracked.keyframe, tracked.registration.T_fixed_moving, answer.T_world_camera,
               answer.submap});
  return answer;
}

/// Continues at a lost frame if enough frames in a row show keyframes that agree on where it is.
FrameRecord Slam::Impl::relocalize(const RgbdFrame& frame, const FrameRecord& lost) {
  const PointCloud cloud = tracker.select_keyframe_points();
  if (cloud.size() == 0) return lost;
  // resume() would drop it.
  if (const auto keyframe = tracker.take_keyframe()) submit(*keyframe);
  // The mapper is for one thread at a time; and every schedule must see the same map.
  jobs.wait_until_left(0);
  const auto pose = mapper.relocalize(frame, cloud);
  if (!pose || !consensus.add(frame.stamp, *pose)) return lost;
  const FrameRecord record = tracker.resume(pose->T_world_camera);
  if (record.status == TrackingStatus::kLost) return lost;
  consensus.clear();
  recognized = pose;
  // The tracker goes on in the map's own world.
  corrections[record.submap] = {pose->submap, SE3()};
  return record;
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
  submitted.push_back({record.submap, record.T_world_camera, std::make_shared<CorrectedPose>()});
  jobs.submit([this, pose_in_map = submitted.back().pose_in_map, input = std::move(input)] {
    *pose_in_map = mapper.add(input);
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
      newest_done.pose_in_map->submap,
      newest_done.pose_in_map->T_world_camera * newest_done.T_world_camera_tracked.inverse()};
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
  if (const auto keyframe = tracker.take_keyframe()) submit(*keyframe);
  apply_corrections(0);
  mapper.optimize_all();
}

Slam::Slam(const Camera& camera, const SlamOptions& options,
           const std::shared_ptr<const Vocabulary>& vocabulary)
    : impl_(std::make_unique<Impl>(camera, options, vocabulary)) {}

Slam::~Slam() = default;
Slam::Slam(Slam&&) noexcept = default;
Slam& Slam::operator=(Slam&&) noexcept = default;

FrameRecord Slam::track(const RgbdFrame& frame) { return impl_->track(frame); }

void Slam::finish() { impl_->finish(); }

Trajectory Slam::trajectory(TrajectoryView view) const {
  if (view == TrajectoryView::kOnline) return online_trajectory(impl_->history);
  impl_->jobs.wait_until_left(0);
  return final_trajectory(impl_->history, impl_->mapper.map());
}

PoseGraph Slam::pose_graph() const {
  impl_->jobs.wait_until_left(0);
  return impl_->mapper.graph();
}

std::vector<Keyframe> Slam::keyframes() const {
  impl_->jobs.wait_until_left(0);
  const MapState& map = impl_->mapper.map();
  std::vector<Keyframe> keyframes;
  for (std::size_t i = 0; i < map.keyframes.size(); ++i) {
    const StoredKeyframe& keyframe = map.keyframes[i];
    keyframes.push_back({keyframe.number, keyframe.stamp, map.submap_at(i), map.graph.pose(i)});
  }
  return keyframes;
}

std::vector<LoopCandidate> Slam::loop_candidates() const {
  impl_->jobs.wait_until_left(0);
  return impl_->mapper.candidates();
}

GraphStatistics Slam::statistics() const {
  impl_->jobs.wait_until_left(0);
  return impl_->mapper.statistics();
}

}  // namespace cvo_slam
