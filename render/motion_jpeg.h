// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace cvo_slam::render {

/// A film of 25 JPEG pictures a second in an AVI file, which any player can play. OpenCV's own
/// writer is not used: every program that links it loads ffmpeg and GStreamer when it starts.
class MotionJpeg {
 public:
  /// Adds a CV_8UC3 picture. Throws DataError if its size differs from that of the earlier ones.
  void add(const cv::Mat& image);
  /// Writes the pictures added so far. Throws OptionError if the name does not end in .avi, and
  /// OutputError if there are no pictures or the file cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  cv::Size size_;
  std::vector<std::string> frames_;
};

}  // namespace cvo_slam::render
