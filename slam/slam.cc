// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/slam/slam.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/slam/job_queue_internal.h"
#include "cvo_slam/slam/keyframe_map_internal.h"
#include "cvo_slam/slam/place_agreement_internal.h"

namespace cvo_slam {
namespace {

SlamOptions checked(SlamOptions options) {
  describe(options).check();
  return options;
}

/// What the map made of a keyframe; written by its job.
struct MappedKeyframe {
  int segment = 0;
  int part = 0;
  SE3 T_world_camera_tracked;
  SE3 T_world_camera;
};

/// What the map has made of a segment.
struct Correction {
  int part = 0;
  SE3 T_corrected_tracked;
};

/// What a new keyframe saw.
struct NewKeyframe {
  std::shared_ptr<const PointCloud> cloud;
  std::shared_ptr<const RgbdFrame> image;  // where loops are looked for
  std::optional<KeyframeLink> place;       // where the lost camera was found
};

/// A new keyframe with what the tracker found of it.
TrackedKeyframe keyframe_of(const FrameRecord& record, NewKeyframe seen) {
  TrackedKeyframe keyframe{record.index,          record.stamp,         record.submap,
                           record.T_world_camera, std::nullopt,         std::move(seen.place),
                           std::move(seen.cloud), std::move(seen.image)};
  if (record.keyframe != record.index) {
    const RegistrationResult& result = record.registration;
    keyframe.link = {record.keyframe, result.T_fixed_moving, result.information, result.cos_theta};
  }
  return keyframe;
}

SE3 pose_in(const PoseGraph& graph, std::size_t keyframe) {
  return graph.nodes()[graph.index_of(node_id(keyframe))].T_world_node;
}

}  // namespace

struct Slam::Impl {
  Impl(const Camera& camera_in, const TrackerOptions& tracker_options_in,
       const SlamOptions& slam_options, const std::shared_ptr<const Vocabulary>& vocabulary)
      : camera(camera_in),
        tracker_options(tracker_options_in),
        options(checked(slam_options)),
        tracker(camera, tracker_options),
        agreement(options.loops.relocalization.frames, tracker_options.lost.max_speed,
                  tracker_options.lost.max_angular_speed),
        map(camera, tracker_options.registration, tracker_options.threads, options, vocabulary),
        jobs(options.schedule) {}

  Camera camera;
  TrackerOptions tracker_options;
  SlamOptions options;
  Tracker tracker;
  PlaceAgreement agreement;                    // of the frames since tracking was lost
  std::map<std::size_t, KeyframeLink> places;  // where the lost camera was found, by frame
  std::vector<FrameRecord> tracked;            // as the tracker answered
  std::vector<FrameRecord> online;             // with what was known at the time
  std::vector<Keyframe> keyframes;             // handed over to the map
  std::deque<std::shared_ptr<const MappedKeyframe>> on_their_way;
  std::map<int, Correction> corrections;  // by segment
  KeyframeMap map;
  JobQueue jobs;  // the last member: its thread ends before what it works on

  FrameRecord track(const RgbdFrame& frame);
  [[nodiscard]] FrameRecord relocalize(const RgbdFrame& frame, const FrameRecord& lost);
  void correct(FrameRecord& record) const;
  void hand_over(const std::optional<TrackerKeyframe>& keyframe);
  void submit(TrackedKeyframe keyframe);
  void apply_corrections(std::size_t left);
  [[nodiscard]] const FrameRecord& record_of(std::size_t frame) const;
  [[nodiscard]] const FrameRecord* next_keyframe(const FrameRecord& frame) const;
  [[nodiscard]] SE3 final_pose(std::size_t record) const;
};

FrameRecord Slam::Impl::track(const RgbdFrame& frame) {
  if (!tracked.empty() && frame.index <= tracked.back().index) {
    throw DataError(
        fmt::format("frame index {} is not above that of the frame before, {}; number "
                    "the frames in ascending order",
                    frame.index, tracked.back().index));
  }
  const TrackedFrame answer = tracker.track(frame);
  FrameRecord record = answer.record;
  if (record.status == TrackingStatus::kTracked) {
    agreement.forget();
  } else if (options.loops.enabled) {
    record = relocalize(frame, record);
  }
  tracked.push_back(record);
  if (record.status == TrackingStatus::kTracked) {
    hand_over(answer.keyframe);
    correct(record);
  }
  online.push_back(record);
  return record;
}

/// Goes on with a lost frame where enough frames in a row show a place that the map knows.
FrameRecord Slam::Impl::relocalize(const RgbdFrame& frame, const FrameRecord& lost) {
  if (!check_images(frame, camera).empty()) return lost;
  hand_over(tracker.take_keyframe());
  jobs.wait_until_left(0);
  const auto place = map.relocalize(frame, tracker.select_keyframe_points());
  if (!place || !agreement.see({frame.stamp, place->part, place->T_world_camera})) return lost;
  FrameRecord record = tracker.resume(place->T_world_camera);
  if (record.status == TrackingStatus::kLost) return lost;
  agreement.forget();
  places[frame.index] = place->link;
  corrections[record.submap] = {place->part, SE3()};
  return record;
}

/// Puts a tracked frame where the map has its segment.
void Slam::Impl::correct(FrameRecord& record) const {
  const auto correction = corrections.find(record.submap);
  if (correction == corrections.end()) return;
  const auto& [part, T_corrected_tracked] = correction->second;
  record.submap = part;
  record.T_world_camera = (T_corrected_tracked * record.T_world_camera).normalized();
}

void Slam::Impl::hand_over(const std::optional<TrackerKeyframe>& keyframe) {
  if (!keyframe) return;
  NewKeyframe seen{keyframe->cloud, nullptr, std::nullopt};
  if (options.loops.enabled) seen.image = std::make_shared<const RgbdFrame>(keyframe->images);
  if (const auto place = places.extract(keyframe->frame)) seen.place = place.mapped();
  submit(keyframe_of(record_of(keyframe->frame), seen));
  apply_corrections(static_cast<std::size_t>(options.correction_delay));
}

void Slam::Impl::submit(TrackedKeyframe keyframe) {
  keyframes.push_back({keyframe.frame, keyframe.stamp, keyframe.segment, keyframe.T_world_camera});
  const auto mapped = std::make_shared<MappedKeyframe>();
  mapped->segment = keyframe.segment;
  mapped->T_world_camera_tracked = keyframe.T_world_camera;
  on_their_way.push_back(mapped);
  jobs.submit([this, mapped, keyframe = std::move(keyframe)] {
    mapped->T_world_camera = map.add(keyframe);
    mapped->part = map.part_of(keyframe.segment);
  });
}

/// Waits until at most so many keyframes are on their way, and takes over what is known of the
/// others.
void Slam::Impl::apply_corrections(std::size_t left) {
  if (on_their_way.size() <= left) return;
  jobs.wait_until_left(left);
  const MappedKeyframe& newest = *on_their_way[on_their_way.size() - left - 1];
  corrections[newest.segment] = {newest.part,
                                 newest.T_world_camera * newest.T_world_camera_tracked.inverse()};
  on_their_way.erase(on_their_way.begin(), on_their_way.end() - static_cast<std::ptrdiff_t>(left));
}

const FrameRecord& Slam::Impl::record_of(std::size_t frame) const {
  return *std::lower_bound(
      tracked.begin(), tracked.end(), frame,
      [](const FrameRecord& record, std::size_t index) { return record.index < index; });
}

/// The keyframe after the frame, where it was tracked against the same keyframe as the frame.
const FrameRecord* Slam::Impl::next_keyframe(const FrameRecord& frame) const {
  const auto next = std::upper_bound(
      keyframes.begin(), keyframes.end(), frame.index,
      [](std::size_t index, const Keyframe& keyframe) { return index < keyframe.frame; });
  if (next == keyframes.end()) return nullptr;
  const FrameRecord& record = record_of(next->frame);
  return record.keyframe == frame.keyframe ? &record : nullptr;
}

/// Where the graph has the frame; for one whose keyframe it does not have yet, the online pose.
/// What the graph has corrected between two keyframes is shared out by time among the frames
/// between.
SE3 Slam::Impl::final_pose(std::size_t record) const {
  const PoseGraph& graph = map.graph();
  const FrameRecord& r = tracked[record];
  if (graph.has_node(node_id(r.index))) return pose_in(graph, r.index);
  if (!graph.has_node(node_id(r.keyframe))) return online[record].T_world_camera;
  const SE3 T_world_keyframe = pose_in(graph, r.keyframe);
  const SE3 T_world_camera = T_world_keyframe * r.registration.T_fixed_moving;
  const FrameRecord* const next = next_keyframe(r);
  if (next == nullptr) return T_world_camera.normalized();
  const SE3 T_world_next_tracked = T_world_keyframe * next->registration.T_fixed_moving;
  const SE3 correction = T_world_next_tracked.inverse() * pose_in(graph, next->index);
  const Timestamp begin = record_of(r.keyframe).stamp;
  const double share = seconds_between(begin, r.stamp) / seconds_between(begin, next->stamp);
  return (T_world_camera * SE3::exp(share * correction.log())).normalized();
}

Slam::Slam(const Camera& camera, const TrackerOptions& tracker, const SlamOptions& options,
           const std::shared_ptr<const Vocabulary>& vocabulary)
    : impl_(std::make_unique<Impl>(camera, tracker, options, vocabulary)) {}

Slam::~Slam() = default;
Slam::Slam(Slam&&) noexcept = default;
Slam& Slam::operator=(Slam&&) noexcept = default;

FrameRecord Slam::track(const RgbdFrame& frame) { return impl_->track(frame); }

void Slam::finish() {
  impl_->hand_over(impl_->tracker.take_keyframe());
  impl_->apply_corrections(0);
  impl_->map.optimize_all();
}

Trajectory Slam::trajectory(TrajectoryView view) const {
  if (view == TrajectoryView::kOnline) return to_trajectory(impl_->online);
  impl_->jobs.wait_until_left(0);
  std::vector<FrameRecord> records = impl_->tracked;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (records[i].status == TrackingStatus::kTracked) {
      records[i].T_world_camera = impl_->final_pose(i);
      records[i].submap = impl_->map.part_of(records[i].submap);
    }
  }
  return to_trajectory(records);
}

PoseGraph Slam::pose_graph() const {
  impl_->jobs.wait_until_left(0);
  return impl_->map.graph();
}

std::vector<Keyframe> Slam::keyframes() const {
  impl_->jobs.wait_until_left(0);
  std::vector<Keyframe> keyframes = impl_->keyframes;
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    keyframes[i].T_world_camera = impl_->map.graph().nodes()[i].T_world_node;
    keyframes[i].segment = impl_->map.part_of(keyframes[i].segment);
  }
  return keyframes;
}

std::vector<LoopCandidate> Slam::loop_candidates() const {
  impl_->jobs.wait_until_left(0);
  return impl_->map.candidates();
}

GraphStatistics Slam::graph_statistics() const {
  impl_->jobs.wait_until_left(0);
  return impl_->map.statistics();
}

}  // namespace cvo_slam
