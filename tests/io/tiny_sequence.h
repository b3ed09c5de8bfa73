// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/io/dataset.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {

/// Returns a camera with so few pixels that a sequence is written in a millisecond.
inline Camera tiny_camera() {
  Camera camera;
  camera.name = "tiny";
  camera.color.width = 8;
  camera.color.height = 6;
  camera.color.fx = camera.color.fy = 8;
  camera.color.cx = 3.5;
  camera.color.cy = 2.5;
  return camera;
}

/// A temporary folder for a sequence of tiny_camera(), and functions that write files into it.
class TinySequence {
 public:
  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

  // NOLINTNEXTLINE(modernize-use-nodiscard): most tests look at the files
  std::filesystem::path write(const std::string& relative, const std::string& text) const {
    return folder_.write(relative, text);
  }
  void write_image(const std::string& relative, const cv::Mat& image) const {
    const auto file = path() / relative;
    std::filesystem::create_directories(file.parent_path());
    cv::imwrite(file.string(), image);
  }
  void write_color(const std::string& relative) const {
    write_image(relative, cv::Mat(6, 8, CV_8UC3, cv::Scalar(10, 20, 30)));
  }
  /// Writes a depth image whose pixels all have the value `units`.
  void write_depth(const std::string& relative, int units = 5000) const {
    write_image(relative, cv::Mat(6, 8, CV_16UC1, cv::Scalar(units)));
  }
  /// Writes two good frames in the layout of TUM RGB-D: colour at 0.00 s and 0.10 s, depth 5 ms
  /// later.
  void write_tum() const {
    write("rgb.txt", "# color images\n0.00 rgb/0.png\n0.10 rgb/1.png\n");
    write("depth.txt", "# depth maps\n0.005 depth/0.png\n0.105 depth/1.png\n");
    for (const char* name : {"0.png", "1.png"}) {
      write_color(std::string("rgb/") + name);
      write_depth(std::string("depth/") + name);
    }
  }

  [[nodiscard]] std::unique_ptr<Dataset> open(const Camera& camera = tiny_camera()) const {
    return open_dataset(path(), {.camera = camera});
  }

 private:
  TemporaryFolder folder_;
};

/// Returns the message of the exception that a call throws, without the folder, or "no error".
template <typename Call>
std::string input_error(const std::filesystem::path& folder, Call call) {
  try {
    static_cast<void>(call());
  } catch (const std::exception& error) {
    std::string text = error.what();
    const std::string prefix = folder.string() + "/";
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      text.erase(at, prefix.size());
    }
    return text;
  }
  return "no error";
}

}  // namespace cvo_slam
