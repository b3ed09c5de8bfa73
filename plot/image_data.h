// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include <opencv2/core/mat.hpp>

namespace cvo_slam {

/// Returns the bytes of a PNG file of the image. Throws Error.
[[nodiscard]] std::string encode_png(const cv::Mat& image);

/// Returns the bytes as text of letters, digits, '+' and '/', padded with '=' (RFC 4648, section
/// 4). SVG and HTML hold images as `data:` addresses of such text.
[[nodiscard]] std::string to_base64(std::string_view bytes);

}  // namespace cvo_slam
