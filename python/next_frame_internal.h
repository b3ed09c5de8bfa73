// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/python/arrays_internal.h"

namespace cvo_slam::python {

/// Returns the frame that was given as arrays, without copying what need not be copied: it is valid
/// as long as they are.
[[nodiscard]] inline RgbdFrame frame_of_arrays(std::size_t index, const pybind11::array& rgb,
                                               const pybind11::array& depth, double stamp,
                                               const std::optional<double>& depth_stamp) {
  RgbdFrame frame;
  frame.index = index;
  frame.stamp = stamp_from(stamp, "stamp");
  frame.depth_stamp = depth_stamp ? stamp_from(*depth_stamp, "depth_stamp") : frame.stamp;
  frame.color = color_image_from(rgb);
  frame.depth = depth_image_from(depth);
  return frame;
}

/// Numbers frames that are given as arrays, from 0.
class NextFrame {
 public:
  NextFrame() = default;
  explicit NextFrame(std::size_t index) : index_(index) {}

  /// Tracks a frame with the interpreter free for other threads. The next frame follows it,
  /// whatever is thrown.
  template <typename Track>
  FrameRecord track(const RgbdFrame& frame, const Track& track) {
    index_ = std::max(index_, frame.index + 1);
    const pybind11::gil_scoped_release release;
    return track(frame);
  }

  [[nodiscard]] RgbdFrame frame(const pybind11::array& rgb, const pybind11::array& depth,
                                double stamp, const std::optional<double>& depth_stamp) const {
    return frame_of_arrays(index_, rgb, depth, stamp, depth_stamp);
  }

 private:
  std::size_t index_ = 0;
};

}  // namespace cvo_slam::python
