// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads all images of a folder with OpenCV's imread in one thread, and does nothing with them: what
// bench/run_cost_of_runs.py compares whole runs with.
//   read_images folder
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

void read_images(const std::filesystem::path& folder) {
  cv::setNumThreads(1);
  const std::set<std::filesystem::path> kinds = {".png", ".jpg", ".jpeg"};
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           folder, std::filesystem::directory_options::follow_directory_symlink)) {
    if (!kinds.contains(entry.path().extension())) continue;
    if (cv::imread(entry.path().string(), cv::IMREAD_UNCHANGED).empty()) {
      throw InputError(entry.path(), "cannot be read");
    }
    ++read;
  }
  fmt::print("{}\n", read);
}

}  // namespace
}  // namespace cvo_slam

int main(int argc, char** argv) {
  return cvo_slam::report_errors([&] {
    if (argc != 2) throw cvo_slam::OptionError("read_images needs one folder");
    cvo_slam::read_images(argv[1]);
  });
}
