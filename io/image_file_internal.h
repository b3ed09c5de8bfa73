// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include <opencv2/core/mat.hpp>

namespace cvo_slam {

/// An 8-bit image of the given size: CV_8UC3 (blue, green, red; an alpha channel is dropped) or
/// CV_8UC1. Throws InputError where the file is missing, broken, or another kind of image.
cv::Mat read_color_image(const std::filesystem::path& file, cv::Size size);

/// A CV_16UC1 image of the given size. Throws InputError like read_color_image().
cv::Mat read_depth_image(const std::filesystem::path& file, cv::Size size);

/// Whether the file can be read as an image of one channel with 16 bits.
bool is_depth_image(const std::filesystem::path& file);

}  // namespace cvo_slam
