// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/exclusive_access.h"

#include <atomic>
#include <string>
#include <thread>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cvo_slam {
namespace {

struct State {
  std::atomic_flag in_use;
  int value = 0;
};

std::string problem_with(const std::unique_ptr<State>& state) {
  try {
    const ExclusiveAccess access(state, "Slam");
  } catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

TEST(ExclusiveAccess, LetsOneFunctionAfterTheOtherIn) {
  const auto state = std::make_unique<State>();
  ExclusiveAccess(state, "Slam")->value = 1;
  const ExclusiveAccess access(state, "Slam");
  EXPECT_EQ(access->value, 1);
}

TEST(ExclusiveAccess, KeepsASecondThreadOut) {
  const auto state = std::make_unique<State>();
  std::string problem;
  {
    const ExclusiveAccess access(state, "Slam");
    std::thread([&] { problem = problem_with(state); }).join();
  }
  EXPECT_THAT(problem, testing::HasSubstr("another thread is in this Slam"));
  EXPECT_EQ(problem_with(state), "");
}

TEST(ExclusiveAccess, NamesAnObjectThatWasMovedFrom) {
  auto state = std::make_unique<State>();
  const auto other = std::move(state);
  EXPECT_THAT(problem_with(state), testing::HasSubstr("this Slam was moved from"));
}

}  // namespace
}  // namespace cvo_slam
