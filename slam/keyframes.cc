// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <utility>

#include "cvo_slam/core/error.h"
#include "cvo_slam/slam/keyframes_internal.h"

namespace cvo_slam {

namespace {

std::size_t bytes_of(const StoredKeyframe& keyframe) {
  return sizeof(StoredKeyframe) + keyframe.cloud.bytes();
}

}  // namespace

double reach_of(const CompactCloud& cloud) {
  double farthest = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    farthest = std::max(farthest, cloud.position(i).norm());
  }
  return farthest;
}

void KeyframeStore::add(StoredKeyframe keyframe) {
  keyframe.reach = reach_of(keyframe.cloud);
  bytes_ += bytes_of(keyframe);
  positions_.emplace(keyframe.number, keyframes_.size());
  keyframes_.push_back(std::move(keyframe));
}

void KeyframeStore::remove(std::size_t position, const Substitute& substitute) {
  const StoredKeyframe& keyframe = keyframes_[position];
  bytes_ -= bytes_of(keyframe);
  substitutes_.emplace(keyframe.number, substitute);
  positions_.erase(keyframe.number);
  keyframes_.erase(keyframes_.begin() + static_cast<std::ptrdiff_t>(position));
  for (std::size_t i = position; i < keyframes_.size(); ++i) positions_[keyframes_[i].number] = i;
}

const Substitute* KeyframeStore::substitute_for(std::size_t number) const {
  const auto substitute = substitutes_.find(number);
  return substitute == substitutes_.end() ? nullptr : &substitute->second;
}

void KeyframeStore::exchange(SavedState& state) {
  std::map<std::size_t, Substitute> sorted(substitutes_.begin(), substitutes_.end());
  state(sorted);
  substitutes_ = {sorted.begin(), sorted.end()};
  for (const auto& [first, substitute] : sorted) {
    std::size_t number = first;
    for (std::size_t steps = 0; steps <= sorted.size() && sorted.contains(number); ++steps) {
      number = sorted.at(number).number;
    }
    if (has(first) || !has(number)) {
      throw DataError("a saved state does not belong to the keyframes of its map");
    }
  }
}

}  // namespace cvo_slam
