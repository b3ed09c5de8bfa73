// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

namespace cvo_slam {

/// The bytes of an image as a PNG file. Throws Error.
[[nodiscard]] std::string encode_png(const cv::Mat& image);

}  // namespace cvo_slam
