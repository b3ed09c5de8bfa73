// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {

/// A sequence of the synthetic room for one test to use and to damage, 160x120 pixels, so that
/// tracking a frame takes milliseconds. A program renders each length once; a test gets a copy.
class RoomSequence {
 public:
  explicit RoomSequence(std::size_t frames) {
    std::filesystem::copy(rendered(frames), path(), std::filesystem::copy_options::recursive);
  }

  /// The sequence's folder, named room; the folder around it is the test's own.
  [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "room"; }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

  /// The images of a kind, "rgb" or "depth", in the order of the frames.
  [[nodiscard]] std::vector<std::filesystem::path> images(const char* kind) const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(path() / kind)) {
      files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
  }

  /// Replaces the colour images of frames by images without anything to see.
  void blank(std::size_t first, std::size_t last) const {
    const auto files = images("rgb");
    for (std::size_t i = first; i <= last; ++i) {
      cv::imwrite(files.at(i), cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(128)));
    }
  }

 private:
  static std::filesystem::path rendered(std::size_t frames) {
    static const TemporaryFolder all;
    auto sequence = all.path() / std::to_string(frames);
    if (!std::filesystem::exists(sequence)) {
      synthetic::write_sequence(sequence, {.frames = frames, .width = 160, .height = 120});
    }
    return sequence;
  }

  TemporaryFolder folder_;
};

}  // namespace cvo_slam
