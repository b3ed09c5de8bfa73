// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdlib>
#include <filesystem>
namespace cvo_slam {
/// The folder of real sequences: $CVO_SLAM_DATA, or ../shared/data beside the checkout.
inline std::filesystem::path test_data() {
  const char* folder = std::getenv("CVO_SLAM_DATA");
  return folder != nullptr ? std::filesystem::path(folder)
                           : std::filesystem::path(CVO_SLAM_SOURCE_DIR) / ".." / "shared" / "data";
}
}  // namespace cvo_slam
/// Skips the test with a clear line where the real data is not on this machine.
#define CVO_SLAM_REQUIRE_DATA(relative)                                                    \
  if (!std::filesystem::exists(cvo_slam::test_data() / (relative)))                        \
  GTEST_SKIP() << "no " << (cvo_slam::test_data() / (relative)) << "; set CVO_SLAM_DATA to run"
