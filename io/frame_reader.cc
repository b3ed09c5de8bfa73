// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <opencv2/core.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/frame_reader_internal.h"
#include "cvo_slam/io/image_file_internal.h"
#include "cvo_slam/io/rgbd_images.h"

namespace cvo_slam {
namespace {

cv::Size image_size(const PinholeCamera& camera) { return {camera.width, camera.height}; }

}  // namespace

FrameReader::FrameReader(const Camera& camera, std::uint16_t invalid_depth)
    : camera_(camera), invalid_depth_(invalid_depth) {
  if (camera.depth) registration_.emplace(camera);
}

void FrameReader::read(const std::filesystem::path& color, const std::filesystem::path& depth,
                       RgbdFrame& frame) const {
  frame.color = read_color_image(color, image_size(camera_.color));
  frame.depth = read_depth(depth);
}

cv::Mat FrameReader::read_depth(const std::filesystem::path& file) const {
  const PinholeCamera& pinhole = camera_.depth ? camera_.depth->pinhole : camera_.color;
  cv::Mat depth = read_depth_image(file, image_size(pinhole));
  if (invalid_depth_ != 0) depth.setTo(0, depth == invalid_depth_);
  if (registration_) depth = registration_->to_color(depth);
  if (cv::countNonZero(depth) == 0) throw InputError(file, "the depth image has no valid pixel");
  return depth;
}

RgbdFrame read_rgbd_images(const std::filesystem::path& color, const std::filesystem::path& depth,
                           const Camera& camera) {
  camera.check();
  RgbdFrame frame;
  FrameReader(camera).read(color, depth, frame);
  return frame;
}

}  // namespace cvo_slam
