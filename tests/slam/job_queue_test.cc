// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/slam/job_queue_internal.h"

namespace cvo_slam {
namespace {

TEST(JobQueue, DoesAllJobsInOrder) {
  for (const Schedule schedule : {Schedule::kInline, Schedule::kPipelined}) {
    std::vector<int> done;
    std::vector<int> expected;
    JobQueue jobs(schedule);
    for (int i = 0; i < 100; ++i) {
      expected.push_back(i);
      jobs.submit([&done, i] { done.push_back(i); });
    }
    jobs.wait_until_left(0);
    EXPECT_EQ(done, expected);
  }
}

TEST(JobQueue, WhatAJobThrowsArrivesAtTheCaller) {
  JobQueue jobs(Schedule::kPipelined);
  jobs.submit([] { throw std::runtime_error("broken"); });
  EXPECT_THROW(jobs.wait_until_left(0), std::runtime_error);
  EXPECT_NO_THROW(jobs.wait_until_left(0));
}

}  // namespace
}  // namespace cvo_slam
