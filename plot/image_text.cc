// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/plot/image_text.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <opencv2/imgproc.hpp>

namespace cvo_slam {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;

/// Returns OpenCV's scale of a font of a size [px]. Capitals are 21 units high in the font, and
/// 0.72 em in most typefaces.
double scale_of(double size) { return 0.72 * size / 21; }

int thickness_of(double size, double boldness) {
  return std::max(1, static_cast<int>(std::lround(0.09 * size * boldness)));
}

/// Returns the text in ASCII, which is all that OpenCV's fonts have. Of any other character (UTF-8)
/// the first byte becomes '?' and the rest is dropped.
std::string to_ascii(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0U) == 0x80U) continue;
    result += byte >= 0x20 && byte < 0x7f ? c : '?';
  }
  return result;
}

}  // namespace

ImageTextExtent image_text_extent(std::string_view text, double size) {
  ImageTextExtent extent;
  extent.thickness = thickness_of(size, 1);
  const cv::Size box =
      cv::getTextSize(to_ascii(text), kFont, scale_of(size), extent.thickness, &extent.below);
  extent.width = box.width;
  extent.above = box.height;
  return extent;
}

void draw_image_text(cv::Mat& image, cv::Point origin, std::string_view text, double size,
                     Color color, double boldness) {
  cv::putText(image, to_ascii(text), origin, kFont, scale_of(size),
              cv::Scalar(color.blue, color.green, color.red), thickness_of(size, boldness),
              cv::LINE_AA);
}

}  // namespace cvo_slam
