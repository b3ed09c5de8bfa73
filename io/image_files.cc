// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/image_decoding_internal.h"
#include "cvo_slam/io/image_files_internal.h"
#include "cvo_slam/io/image_header_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

void check_size(cv::Size found, cv::Size expected, const Path& file) {
  if (found == expected) return;
  throw InputError(file,
                   fmt::format("the image has {}x{} pixels, its camera {}x{}; give the camera "
                               "of the recording",
                               found.width, found.height, expected.width, expected.height));
}

/// Reads a file that a list names. A list may name anything, even a device without an end.
std::string read_image_bytes(const Path& file) {
  std::error_code problem;
  const auto status = std::filesystem::status(file, problem);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw InputError(file, "is not a regular file; an image file is needed");
  }
  std::string bytes = read_file(file);
  if (bytes.empty()) throw InputError(file, "the image file is empty; record or copy it again");
  return bytes;
}

ImageHeader header_of(const Path& file, std::string_view bytes) {
  const auto header = parse_image_header(bytes);
  if (!header) {
    throw InputError(file,
                     "is not an image that is read; make it PNG, JPEG, PGM, PPM, BMP or TIFF");
  }
  if (!header->is_whole) {
    throw InputError(file, "the image file is cut off; record or copy it again");
  }
  return *header;
}

/// Returns the image as it is: not converted, not rotated by its EXIF orientation.
cv::Mat decode(const Path& file, cv::Size size) {
  const std::string bytes = read_image_bytes(file);
  check_size(header_of(file, bytes).size, size, file);  // before memory is taken for the pixels
  cv::Mat image = decode_image(bytes);
  if (image.empty()) {
    throw InputError(file, "the image cannot be decoded, it is damaged; record or copy it again");
  }
  check_size(image.size(), size, file);
  return image;
}

/// Returns an 8-bit image: CV_8UC3 (blue, green, red; an alpha channel is dropped) or CV_8UC1.
cv::Mat read_color_image(const Path& file, cv::Size size) {
  cv::Mat image = decode(file, size);
  if (image.depth() != CV_8U || image.channels() == 2) {
    throw InputError(file, fmt::format("a colour image must have 8 bits and 1, 3 or 4 channels, "
                                       "this one has {} and {}; convert it",
                                       8 * image.elemSize1(), image.channels()));
  }
  if (image.channels() == 4) cv::cvtColor(image, image, cv::COLOR_BGRA2BGR);
  return image;
}

/// Returns a CV_16UC1 image.
cv::Mat read_depth_image(const Path& file, cv::Size size) {
  cv::Mat image = decode(file, size);
  if (image.type() != CV_16UC1) {
    throw InputError(file,
                     fmt::format("a depth image must have 16 bits and 1 channel, this one has {} "
                                 "and {}; convert it",
                                 8 * image.elemSize1(), image.channels()));
  }
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
  frame.color = read_color(color);
  frame.depth = register_depth(read_raw_depth(depth));
  if (cv::countNonZero(frame.depth) == 0) {
    throw InputError(depth, "the depth image has no valid pixel; see depth_scale of the camera");
  }
  return frame;
}

cv::Mat FrameReader::read_color(const Path& file) const {
  return read_color_image(file, image_size(camera_.color));
}

cv::Mat FrameReader::read_raw_depth(const Path& file) const {
  const PinholeCamera& pinhole = camera_.depth ? camera_.depth->pinhole : camera_.color;
  cv::Mat depth = read_depth_image(file, image_size(pinhole));
  if (invalid_depth_ != 0) depth.setTo(0, depth == invalid_depth_);
  return depth;
}

cv::Mat FrameReader::register_depth(const cv::Mat& raw) const {
  return registration_ ? registration_->register_depth(raw) : raw;
}

cv::Size read_image_size(const Path& file) { return header_of(file, read_image_bytes(file)).size; }

bool is_depth_image(const Path& file) {
  constexpr int kLargest = 16384;  // [px]; a side of a larger image is a mistake
  try {
    const cv::Size size = read_image_size(file);
    if (size.width > kLargest || size.height > kLargest) return false;
    return decode(file, size).type() == CV_16UC1;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace cvo_slam
