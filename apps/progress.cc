// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/progress.h"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace cvo_slam {
namespace {

/// Ignores a stderr that cannot be written, unlike fmt::print() and streams.
void write_to_stderr(const std::string& text) {
  static_cast<void>(std::fputs(text.c_str(), stderr));
  static_cast<void>(std::fflush(stderr));
}

}  // namespace

Progress::Progress(std::size_t total, bool quiet)
    : total_(total), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (within_line_) write_to_stderr("\n");
}

void Progress::update(std::size_t done, const std::string& state) {
  if (quiet_) return;
  if (terminal_) {
    draw_bar(done, state);
  } else {
    print_line(done, state);
  }
}

std::string Progress::summary(std::size_t done, const std::string& state) const {
  const std::chrono::duration<double> elapsed = Clock::now() - start_;
  const double fps = static_cast<double>(done) / elapsed.count();
  const std::string after = state.empty() ? "" : "  " + state;
  if (total_ == 0) return fmt::format("{}  {:.1f} fps{}", done, fps, after);
  return fmt::format("{}/{}  {:.1f} fps, ETA {:.0f} s{}", done, total_, fps,
                     static_cast<double>(total_ - done) / fps, after);
}

void Progress::draw_bar(std::size_t done, const std::string& state) {
  constexpr std::size_t kWidth = 30;
  constexpr std::chrono::milliseconds kInterval(100);  // redrawing at each frame would cost time
  const auto now = Clock::now();
  const bool is_last = done == total_;
  if (!is_last && now - last_drawn_ < kInterval) return;
  last_drawn_ = now;
  if (total_ == 0) {
    write_to_stderr(fmt::format("\r\x1b[K{}", summary(done, state)));
    within_line_ = true;
    return;
  }
  const std::size_t filled = kWidth * done / total_;
  write_to_stderr(fmt::format("\r\x1b[K[{:#<{}}{:.<{}}] {}{}", "", filled, "", kWidth - filled,
                              summary(done, state), is_last ? "\n" : ""));
  within_line_ = !is_last;
}

void Progress::print_line(std::size_t done, const std::string& state) {
  constexpr std::size_t kFramesOfALine = 100;  // of a number that is not known
  const std::size_t tenths = total_ == 0 ? done / kFramesOfALine : 10 * done / total_;
  if (tenths == tenths_) return;
  tenths_ = tenths;
  write_to_stderr(fmt::format("frame {}\n", summary(done, state)));
}

}  // namespace cvo_slam
