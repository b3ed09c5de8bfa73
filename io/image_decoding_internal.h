// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

namespace cvo_slam {

/// Returns the image in the bytes of a file as it is: not converted, not rotated by its EXIF
/// orientation, colours as blue, green, red. Empty if the bytes cannot be decoded. Whole JPEG files
/// are decoded by TurboJPEG in half the time of OpenCV, to the same bytes; all others, also those
/// that TurboJPEG has something to say about, by OpenCV.
[[nodiscard]] cv::Mat decode_image(const std::string& bytes);

}  // namespace cvo_slam
