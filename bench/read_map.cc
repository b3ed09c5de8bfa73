// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What reading a map costs beside reading and checksumming its files, in CPU time: medians of
// rounds that take turns. Slam(map) makes the words of the features anew and is listed apart.
//   read_map folder [rounds]
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/slam/slam.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

double cpu_milliseconds(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::uintmax_t read_and_check(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  std::uint32_t sum = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string content = read_file(entry.path());
    bytes += content.size();
    sum ^= crc32_of(content);
  }
  return sum == 0 ? 0 : bytes;  // the sum is used, so that it is computed
}

void measure(const fs::path& folder, int rounds) {
  std::vector<double> checked;
  std::vector<double> read;
  std::vector<double> loaded;
  std::uintmax_t bytes = 0;
  std::size_t keyframes = 0;
  const auto vocabulary = builtin_vocabulary();
  for (int i = 0; i < rounds; ++i) {
    checked.push_back(cpu_milliseconds([&] { bytes = read_and_check(folder); }));
    Map map;
    read.push_back(cpu_milliseconds([&] { map = read_map(folder); }));
    keyframes = map.keyframes.size();
    loaded.push_back(
        cpu_milliseconds([&] { const Slam slam(map, {}, MapUse::kLocalize, vocabulary); }));
  }
  fmt::print(
      "keyframes {}\nbytes_per_keyframe {:.0f}\nread_and_check_ms {:.2f}\nread_map_ms {:.2f}\n"
      "ratio {:.2f}\nslam_ms {:.2f}\n",
      keyframes,
      static_cast<double>(bytes) / static_cast<double>(std::max<std::size_t>(1, keyframes)),
      median(checked), median(read), median(read) / median(checked), median(loaded));
}

}  // namespace
}  // namespace cvo_slam

int main(int argc, char** argv) {
  return cvo_slam::report_errors([&] {
    if (argc != 2 && argc != 3) throw cvo_slam::OptionError("read_map needs the folder of a map");
    cvo_slam::measure(argv[1], argc == 3 ? std::stoi(argv[2]) : 21);
  });
}
