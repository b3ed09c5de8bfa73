// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/image_files_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

/// Returns true if a PNG or JPEG file has its end. OpenCV silently fills the rest of a JPEG file
/// that is cut off with grey, and libpng writes to stderr.
bool is_whole(std::string_view bytes) {
  constexpr std::string_view kPngStart("\x89PNG\r\n\x1a\n", 8);
  constexpr std::string_view kPngEnd("IEND\xae\x42\x60\x82", 8);
  constexpr std::string_view kJpegStart("\xff\xd8", 2);
  constexpr std::string_view kJpegEnd("\xff\xd9", 2);
  // Some writers pad their files.
  constexpr std::size_t kPadding = 64;
  const std::string_view tail =
      bytes.substr(bytes.size() - std::min(bytes.size(), kPngEnd.size() + kPadding));
  if (bytes.starts_with(kPngStart)) return tail.find(kPngEnd) != std::string_view::npos;
  if (bytes.starts_with(kJpegStart)) return tail.find(kJpegEnd) != std::string_view::npos;
  return !bytes.empty();
}

/// Returns the image as it is: not converted, not rotated by its EXIF orientation.
cv::Mat decode(const Path& file) {
  // Not cv::imread, which writes a warning to stderr if the file is missing.
  const std::string bytes = read_file(file);
  if (!is_whole(bytes)) throw InputError(file, "the image file is empty or cut off");
  cv::Mat image;
  try {
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1,
                         const_cast<char*>(bytes.data()));  // NOLINT: only read from
    image = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) throw InputError(file, "the image cannot be decoded; the file is broken");
  return image;
}

void check_size(const cv::Mat& image, cv::Size size, const Path& file) {
  if (image.size() == size) return;
  throw InputError(file, fmt::format("the image has {}x{} pixels, its camera {}x{}", image.cols,
                                     image.rows, size.width, size.height));
}

/// Returns an 8-bit image: CV_8UC3 (blue, green, red; an alpha channel is dropped) or CV_8UC1.
cv::Mat read_color_image(const Path& file, cv::Size size) {
  cv::Mat image = decode(file);
  if (image.depth() != CV_8U || image.channels() == 2) {
    throw InputError(file, fmt::format("a colour image must have 8 bits and 1, 3 or 4 channels, "
                                       "this one has {} and {}",
                                       8 * image.elemSize1(), image.channels()));
  }
  check_size(image, size, file);
  if (image.channels() == 4) cv::cvtColor(image, image, cv::COLOR_BGRA2BGR);
  return image;
}

/// Returns a CV_16UC1 image.
cv::Mat read_depth_image(const Path& file, cv::Size size) {
  cv::Mat image = decode(file);
  if (image.type() != CV_16UC1) {
    throw InputError(
        file, fmt::format("a depth image must have 16 bits and 1 channel, this one has {} and {}",
                          8 * image.elemSize1(), image.channels()));
  }
  check_size(image, size, file);
  return image;
}

cv::Size image_size(const PinholeCamera& camera) { return {camera.width, camera.height}; }

}  // namespace

FrameReader::FrameReader(const Camera& camera, std::uint16_t invalid_depth)
    : camera_(camera), invalid_depth_(invalid_depth) {
  if (camera.depth) registration_.emplace(camera);
}

RgbdFrame FrameReader::read(const Path& color, const Path& depth) const {
  RgbdFrame frame;
  frame.color = read_color_image(color, image_size(camera_.color));
  frame.depth = read_depth(depth);
  return frame;
}

cv::Mat FrameReader::read_depth(const Path& file) const {
  const PinholeCamera& pinhole = camera_.depth ? camera_.depth->pinhole : camera_.color;
  cv::Mat depth = read_depth_image(file, image_size(pinhole));
  if (invalid_depth_ != 0) depth.setTo(0, depth == invalid_depth_);
  if (registration_) depth = registration_->register_depth(depth);
  if (cv::countNonZero(depth) == 0) throw InputError(file, "the depth image has no valid pixel");
  return depth;
}

bool is_depth_image(const Path& file) {
  try {
    return decode(file).type() == CV_16UC1;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace cvo_slam
