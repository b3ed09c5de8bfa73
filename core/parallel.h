// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>

namespace cvo_slam {

/// Runs loops on a bounded number of threads, with results that do not depend on that number: the
/// range is divided into chunks of a fixed size, each chunk writes to its own slot, and the caller
/// combines the slots in order. Each object that computes has its own executor; there is no
/// process-wide setting.
class Executor {
 public:
  /// `threads` >= 1; with 1 everything runs in the calling thread.
  explicit Executor(int threads = 1);
  ~Executor();
  ///@{
  /// Takes over the threads of `other`, which runs its loops in the calling thread from then on.
  Executor(Executor&& other) noexcept;
  Executor& operator=(Executor&& other) noexcept;
  ///@}

  /// Returns the largest number of threads that a loop runs on, at least 1.
  [[nodiscard]] int threads() const { return threads_; }

  /// Calls f(chunk, begin, end) for each chunk of [0, n), in any order, and returns when all are
  /// done. There are chunk_count(n, chunk_size) chunks; the last may be shorter.
  template <typename Function>
  void for_each_chunk(std::size_t n, std::size_t chunk_size, const Function& f) const {
    run(n, chunk_size, &f,
        [](const void* function, std::size_t chunk, std::size_t begin, std::size_t end) {
          (*static_cast<const Function*>(function))(chunk, begin, end);
        });
  }

  /// Returns the number of chunks of a range: n / chunk_size, rounded up.
  [[nodiscard]] static std::size_t chunk_count(std::size_t n, std::size_t chunk_size) {
    return (n + chunk_size - 1) / chunk_size;
  }

 private:
  struct Arena;
  // A pointer to a function with its object, because a std::function may allocate memory.
  using Call = void (*)(const void* function, std::size_t chunk, std::size_t begin,
                        std::size_t end);

  void run(std::size_t n, std::size_t chunk_size, const void* function, Call call) const;

  int threads_;
  std::unique_ptr<Arena> arena_;  // null with one thread
};

}  // namespace cvo_slam
