// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "cvo_slam/core/rgbd_frame.h"

namespace cvo_slam {

/// Where frames come from: a recording, a camera.
class FrameSource {
 public:
  FrameSource() = default;
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;
  virtual ~FrameSource() = default;

  /// Returns the next frame; nothing after the last one.
  [[nodiscard]] virtual std::optional<RgbdFrame> next() = 0;
};

/// Opens a recording at its first frame, with colour and depth images paired by their stamps after
/// the depth offset (Camera::depth_offset) [s] was added to those of the depth images.
using FramesPairedWith = std::function<std::unique_ptr<FrameSource>(double depth_offset)>;

}  // namespace cvo_slam
