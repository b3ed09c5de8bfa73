// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/io/depth_registration.h"

namespace cvo_slam {

/// Reads the images of one camera's frames and registers depth to colour if the camera needs it.
class FrameReader {
 public:
  /// A depth of `invalid_depth` units means "no measurement", as 0 does.
  explicit FrameReader(const Camera& camera, std::uint16_t invalid_depth = 0);

  /// Returns a frame with these images and no stamps. Throws InputError if a file is missing,
  /// broken, another kind of image or of another size than the camera's, or if the depth image has
  /// no valid pixel. May be called from several threads.
  [[nodiscard]] RgbdFrame read(const std::filesystem::path& color,
                               const std::filesystem::path& depth) const;
  /// The steps of read(): the colour image; depth as it is in the file, without values that mean
  /// "no measurement"; and the same, registered to colour.
  [[nodiscard]] cv::Mat read_color(const std::filesystem::path& file) const;
  [[nodiscard]] cv::Mat read_raw_depth(const std::filesystem::path& file) const;
  [[nodiscard]] cv::Mat register_depth(const cv::Mat& raw) const;

 private:
  Camera camera_;
  std::uint16_t invalid_depth_;
  std::optional<DepthRegistration> registration_;
};

/// Returns the size of an image without decoding it. Throws InputError.
cv::Size read_image_size(const std::filesystem::path& file);

/// Returns true if the file can be read as an image of one channel with 16 bits.
bool is_depth_image(const std::filesystem::path& file);

}  // namespace cvo_slam
