// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace cvo_slam {

/// Reports on stderr how far a run is: a bar with fps and ETA on a terminal, elsewhere a plain line
/// at every tenth of the way. Never fails: a stderr that cannot be written is no reason to end a
/// run.
class Progress {
 public:
  Progress(std::size_t total, bool quiet);
  /// Ends the bar's line where the way was not gone to its end.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of the frames are through; `state` is a word on the last one, or empty.
  void update(std::size_t done, const std::string& state);

 private:
  using Clock = std::chrono::steady_clock;

  void draw_bar(std::size_t done, const std::string& state);
  void print_line(std::size_t done, const std::string& state);
  [[nodiscard]] std::string summary(std::size_t done, const std::string& state) const;

  std::size_t total_;
  bool quiet_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_;
  std::size_t tenths_ = 0;
  bool within_line_ = false;
};

}  // namespace cvo_slam
