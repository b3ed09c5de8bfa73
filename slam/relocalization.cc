// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "cvo_slam/slam/relocalization_internal.h"

namespace cvo_slam {

Relocalization relocalize(const RgbdFrame& images, const PointCloud& cloud, const MapState& map,
                          LoopClosing& loop_closing) {
  const std::vector<LoopMatch> matches = loop_closing.recognize_lost(images, cloud);
  Relocalization result;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    LoopVerdict verdict = result.pose
                              ? rejected(matches[i], "another keyframe is recognised already")
                              : loop_closing.judge_lost(matches, i, images.stamp, map);
    verdict.row.relocalization = true;
    if (verdict.unconfirmed) {
      const std::size_t position = map.keyframes.position_of(matches[i].keyframe);
      const SE3 T_world_camera = map.graph.pose(position) * verdict.unconfirmed->T_older_newer;
      result.pose = RecognizedPose{matches[i].keyframe, *verdict.unconfirmed,
                                   T_world_camera.normalized(), map.submap_at(position), i};
    }
    result.rows.push_back(std::move(verdict.row));
  }
  return result;
}

PoseConsensus::PoseConsensus(int frames, double max_speed, double max_angular_speed)
    : frames_(frames), max_speed_(max_speed), max_angular_speed_(max_angular_speed) {}

bool PoseConsensus::add(const Timestamp& stamp, double period, const RecognizedPose& pose) {
  constexpr double kShortest = 0.06;    // [s]; images of less say the same thing twice
  constexpr double kLongest = 0.5;      // [s]; after more the camera may be anywhere
  constexpr double kLongestPeriod = 1;  // [s]
  const double longest = std::max(kLongest, (frames_ + 1) * std::min(period, kLongestPeriod));
  const Observation observation{stamp, pose.submap, pose.T_world_camera};
  std::erase_if(observations_,
                [&](const Observation& earlier) { return !agree(earlier, observation, longest); });
  observations_.push_back(observation);
  if (count() < frames_) return false;
  return frames_ == 1 || seconds_between(observations_.front().stamp, stamp) >= kShortest;
}

bool PoseConsensus::agree(const Observation& a, const Observation& b, double longest) const {
  if (a.submap != b.submap) return false;
  constexpr double kTranslation = 0.05;  // [m]; that either may be wrong by
  constexpr double kRotation = 0.05;     // [rad]
  const double seconds = std::abs(seconds_between(a.stamp, b.stamp));
  // Nobody moves at the highest speed for long.
  constexpr double kLongestMotion = 0.5;  // [s]
  const double moving = std::min(seconds, kLongestMotion);
  const SE3 motion = a.T_world_camera.inverse() * b.T_world_camera;
  return seconds <= longest && motion.translation().norm() <= kTranslation + max_speed_ * moving &&
         motion.angle() <= kRotation + max_angular_speed_ * moving;
}

}  // namespace cvo_slam
