// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Replays the corpus of the fuzzers: inputs that once broke a parser, and seeds that reach its
// branches. Each also cut off everywhere.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cvo_slam/core/files.h"
#include "cvo_slam/tests/fuzz/targets.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

class FuzzCorpus : public testing::TestWithParam<FuzzTarget> {};

TEST_P(FuzzCorpus, NoInputBreaksTheParser) {
  const fs::path folder = fs::path(CVO_SLAM_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam().name;
  std::size_t inputs = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string bytes = read_file(entry.path());
    run_fuzz_target(GetParam().name, bytes);
    constexpr std::size_t kCuts = 50;
    for (std::size_t i = 0; i < kCuts; ++i) {
      run_fuzz_target(GetParam().name, std::string_view(bytes).substr(0, i * bytes.size() / kCuts));
    }
    ++inputs;
  }
  EXPECT_GT(inputs, 0U) << folder;
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpus,
                         testing::ValuesIn(fuzz_targets().begin(), fuzz_targets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace cvo_slam
