// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "cvo_slam/slam/keyframes_internal.h"

namespace cvo_slam {
namespace {

double reach_of(const PointCloud& cloud) {
  float farthest2 = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float distance2 =
        cloud.x[i] * cloud.x[i] + cloud.y[i] * cloud.y[i] + cloud.z[i] * cloud.z[i];
    farthest2 = std::max(farthest2, distance2);
  }
  return std::sqrt(static_cast<double>(farthest2));
}

std::size_t bytes_of(const PointCloud& cloud) {
  std::size_t floats = cloud.x.capacity() + cloud.y.capacity() + cloud.z.capacity() +
                       cloud.u.capacity() + cloud.v.capacity();
  for (const auto& feature : cloud.features) floats += feature.capacity();
  return sizeof(PointCloud) + floats * sizeof(float);
}

}  // namespace

void KeyframeStore::add(StoredKeyframe keyframe) {
  keyframe.reach = reach_of(*keyframe.cloud);
  bytes_ += sizeof(StoredKeyframe) + bytes_of(*keyframe.cloud);
  positions_.emplace(keyframe.number, keyframes_.size());
  keyframes_.push_back(std::move(keyframe));
}

}  // namespace cvo_slam
