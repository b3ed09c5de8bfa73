// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>

#include "cvo_slam/slam/appearance_cache_internal.h"

namespace cvo_slam {

std::shared_ptr<const Appearance> AppearanceCache::of(const RgbdFrame& images) {
  {
    const std::scoped_lock lock(mutex_);
    const auto known = std::find_if(newest_.begin(), newest_.end(), [&](const auto& appearance) {
      return appearance->id == images.index;
    });
    if (known != newest_.end()) {
      std::rotate(known, known + 1, newest_.end());  // asked for last
      return newest_.back();
    }
  }
  auto appearance = detector_.extract(images);  // may be done twice: the results are the same
  constexpr std::size_t kMost = 6;  // three keyframes, a frame after them, and the map's delay
  const std::scoped_lock lock(mutex_);
  newest_.push_back(appearance);
  if (newest_.size() > kMost) newest_.pop_front();
  return appearance;
}

}  // namespace cvo_slam
