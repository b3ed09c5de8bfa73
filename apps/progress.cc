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
  return fmt::format("{}/{}  {:.1f} fps, ETA {:.0f} s{}{}", done, total_, fps,
                     static_cast<double>(total_ - done) / fps, state.empty() ? "" : "  ", state);
}

void Progress::draw_bar(std::size_t done, const std::string& state) {
  constexpr std::size_t kWidth = 30;
  constexpr std::chrono::milliseconds kInterval(100);  // redrawing at each frame would cost time
  const auto now = Clock::now();
  if (done < total_ && now - last_drawn_ < kInterval) return;
  last_drawn_ = now;
  const std::size_t filled = kWidth * done / total_;
  write_to_stderr(fmt::format("\r\x1b[K[{:#<{}}{:.<{}}] {}{}", "", filled, "", kWidth - filled,
                              summary(done, state), done == total_ ? "\n" : ""));
  within_line_ = done < total_;
}

void Progress::print_line(std::size_t done, const std::string& state) {
  const std::size_t tenths = 10 * done / total_;
  if (tenths == tenths_) return;
  tenths_ = tenths;
  write_to_stderr(fmt::format("frame {}\n", summary(done, state)));
}

}  // namespace cvo_slam
