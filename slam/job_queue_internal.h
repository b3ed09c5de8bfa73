// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// Does jobs one after the other in the order in which they were given: at once, or in a thread of
/// its own.
class JobQueue {
 public:
  explicit JobQueue(Schedule schedule);
  /// Waits for the job in work; the others are not done any more.
  ~JobQueue();
  JobQueue(JobQueue&&) = delete;
  JobQueue& operator=(JobQueue&&) = delete;

  void submit(std::function<void()> job);
  /// Returns when at most `jobs` of those submitted are not yet done. Throws what a job threw.
  void wait_until_left(std::size_t jobs);

 private:
  struct Worker;
  std::unique_ptr<Worker> worker_;  // empty: at once
};

}  // namespace cvo_slam
