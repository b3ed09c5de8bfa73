// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/parallel.h"

#include <algorithm>
#include <atomic>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace cvo_slam {
namespace {

/// Number of loops that were handed to TBB. It orders what was written before a loop before its
/// chunks for the thread sanitizer; it is no member, because a chunk must not read anything before
/// it.
std::atomic<std::size_t> loops_started{0};

}  // namespace

struct Executor::Arena {
  explicit Arena(int threads) : arena(threads) {}
  tbb::task_arena arena;
};

Executor::Executor(int threads) : threads_(std::max(1, threads)) {
  if (threads_ > 1) arena_ = std::make_unique<Arena>(threads_);
}

Executor::~Executor() = default;
Executor::Executor(Executor&&) noexcept = default;
Executor& Executor::operator=(Executor&&) noexcept = default;

void Executor::run(std::size_t n, std::size_t chunk_size, const void* function, Call call) const {
  const std::size_t chunks = chunk_count(n, chunk_size);
  const auto run_chunk = [&](std::size_t chunk) {
    call(function, chunk, chunk * chunk_size, std::min(n, (chunk + 1) * chunk_size));
  };
  if (!arena_) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) run_chunk(chunk);
    return;
  }
  // TBB itself orders the chunks after the call and before the return. The counters repeat this for
  // the thread sanitizer, because Debian's libtbb is not instrumented.
  std::atomic<std::size_t> finished{0};
  const auto run_and_count = [&](std::size_t chunk) {
    static_cast<void>(loops_started.load(std::memory_order_acquire));
    run_chunk(chunk);
    finished.fetch_add(1, std::memory_order_release);
  };
  loops_started.fetch_add(1, std::memory_order_release);
  arena_->arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, run_and_count); });
  static_cast<void>(finished.load(std::memory_order_acquire));
}

}  // namespace cvo_slam
