// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/loop/loop_detector.h"

namespace cvo_slam {

/// The features and words of the last few images: the tracker and the map ask for those of the same
/// ones. For several threads.
class AppearanceCache {
 public:
  /// `detector` must outlive the object.
  explicit AppearanceCache(const LoopDetector& detector) : detector_(detector) {}

  /// Returns those of an image. Images with the same index are the same.
  [[nodiscard]] std::shared_ptr<const Appearance> of(const RgbdFrame& images);

 private:
  const LoopDetector& detector_;
  std::mutex mutex_;
  std::deque<std::shared_ptr<const Appearance>> newest_;
};

}  // namespace cvo_slam
