// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What an image file says of itself, known before memory for its pixels is taken.
#pragma once

#include <optional>
#include <string_view>

#include <opencv2/core/types.hpp>

namespace cvo_slam {

struct ImageHeader {
  cv::Size size;
  /// False if the file ends before its image does: OpenCV silently fills the rest of such a JPEG
  /// file with grey, and libpng writes to stderr. Bytes behind the image do no harm.
  bool is_whole = true;
};

/// Returns the header of a PNG, JPEG, PGM, PPM, BMP or TIFF file; empty if the bytes are none of
/// them.
[[nodiscard]] std::optional<ImageHeader> parse_image_header(std::string_view bytes);

}  // namespace cvo_slam
