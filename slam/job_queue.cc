// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "cvo_slam/slam/job_queue_internal.h"

namespace cvo_slam {

struct JobQueue::Worker {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::function<void()>> jobs;  // the first one is in work
  std::exception_ptr failure;
  bool stop = false;
  std::thread thread{[this] { run(); }};

  ~Worker() {
    {
      const std::lock_guard lock(mutex);
      stop = true;
    }
    changed.notify_all();
    thread.join();
  }

  void run() {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [this] { return stop || !jobs.empty(); });
      if (stop) return;
      const std::function<void()>& job = jobs.front();  // stays where it is while others come
      lock.unlock();
      std::exception_ptr problem;
      try {
        job();
      } catch (...) {
        problem = std::current_exception();
      }
      lock.lock();
      if (problem) failure = problem;
      jobs.pop_front();
      changed.notify_all();
    }
  }
};

JobQueue::JobQueue(Schedule schedule)
    : worker_(schedule == Schedule::kPipelined ? std::make_unique<Worker>() : nullptr) {}

JobQueue::~JobQueue() = default;

void JobQueue::submit(std::function<void()> job) {
  if (!worker_) return job();
  {
    const std::lock_guard lock(worker_->mutex);
    worker_->jobs.push_back(std::move(job));
  }
  worker_->changed.notify_all();
}

void JobQueue::wait_until_left(std::size_t jobs) {
  if (!worker_) return;
  std::unique_lock lock(worker_->mutex);
  worker_->changed.wait(lock, [&] { return worker_->jobs.size() <= jobs; });
  if (worker_->failure) std::rethrow_exception(std::exchange(worker_->failure, nullptr));
}

}  // namespace cvo_slam
