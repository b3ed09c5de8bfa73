// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace cvo_slam {

/// Shows the progress of a run on stderr: a bar with fps and ETA on a terminal, otherwise a plain
/// line after every tenth of the frames. Where the number of frames is not known, it counts them,
/// on a line for every hundred. It never fails: a stderr that cannot be written is no reason to end
/// a run.
class Progress {
 public:
  /// `total` is the number of frames; 0 if it is not known.
  Progress(std::size_t total, bool quiet);
  /// Ends the line of a bar that did not reach its end.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Reports that `done` frames are finished; `state` describes the last one, or is empty.
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
