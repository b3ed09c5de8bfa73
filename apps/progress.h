// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace cvo_slam {

/// Reports on stderr how far a run is: a bar with fps and ETA on a terminal, elsewhere a plain line
/// at every tenth of the way.
class Progress {
 public:
  Progress(std::size_t total, bool quiet);

  /// `done` of the frames are through; `state` is a word on the last one.
  void update(std::size_t done, const std::string& state);

 private:
  using Clock = std::chrono::steady_clock;

  void draw_bar(std::size_t done, const std::string& state);
  void print_line(std::size_t done, const std::string& state);
  [[nodiscard]] std::string speed(std::size_t done) const;

  std::size_t total_;
  bool quiet_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_;
  std::size_t tenths_ = 0;
};

}  // namespace cvo_slam
