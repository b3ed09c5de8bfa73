// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/io/depth_registration.h"

namespace cvo_slam {

/// Reads the images of one camera's frames, with depth registered to colour.
class FrameReader {
 public:
  /// Depth of `invalid_depth` units means "none", as 0 does.
  explicit FrameReader(const Camera& camera, std::uint16_t invalid_depth = 0);

  /// Sets the frame's images. Throws InputError where a file is missing or broken, or the depth
  /// image has no valid pixel. May be called from several threads.
  void read(const std::filesystem::path& color, const std::filesystem::path& depth,
            RgbdFrame& frame) const;

 private:
  [[nodiscard]] cv::Mat read_depth(const std::filesystem::path& file) const;

  Camera camera_;
  std::uint16_t invalid_depth_;
  std::optional<DepthRegistration> registration_;
};

}  // namespace cvo_slam
