// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "cvo_slam/slam/keyframes_internal.h"

namespace cvo_slam {

double reach_of(const CompactCloud& cloud) {
  double farthest = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    farthest = std::max(farthest, cloud.position(i).norm());
  }
  return farthest;
}

void KeyframeStore::add(StoredKeyframe keyframe) {
  keyframe.reach = reach_of(keyframe.cloud);
  bytes_ += sizeof(StoredKeyframe) + keyframe.cloud.bytes();
  positions_.emplace(keyframe.number, keyframes_.size());
  keyframes_.push_back(std::move(keyframe));
}

}  // namespace cvo_slam
