// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace cvo_slam::render {

/// A film of JPEG pictures in an AVI file, which any player knows. OpenCV's own writer would make
/// every program that links it load ffmpeg and GStreamer when it starts.
class MotionJpeg {
 public:
  explicit MotionJpeg(int frames_per_second = 25) : frames_per_second_(frames_per_second) {}

  /// CV_8UC3; throws DataError where the size is not that of the pictures before.
  void add(const cv::Mat& image);
  /// The pictures so far. Throws OutputError, also where they are none, and OptionError where the
  /// file's name does not end in .avi.
  void write(const std::filesystem::path& file) const;

 private:
  int frames_per_second_;
  cv::Size size_;
  std::vector<std::string> frames_;
};

}  // namespace cvo_slam::render
