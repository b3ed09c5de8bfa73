// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/progress.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

namespace cvo_slam {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

/// Replaces stderr by a terminal for as long as it lives.
class TerminalStderr {
 public:
  TerminalStderr() : terminal_(posix_openpt(O_RDWR | O_NOCTTY)), stderr_(dup(STDERR_FILENO)) {
    grantpt(terminal_);
    unlockpt(terminal_);
    const int end = open(ptsname(terminal_), O_RDWR | O_NOCTTY);
    dup2(end, STDERR_FILENO);
    close(end);
  }
  ~TerminalStderr() {
    dup2(stderr_, STDERR_FILENO);
    close(stderr_);
    close(terminal_);
  }
  TerminalStderr(const TerminalStderr&) = delete;
  TerminalStderr& operator=(const TerminalStderr&) = delete;

  /// Returns what was written since the last call; waits up to ten seconds for it.
  [[nodiscard]] std::string text() const {
    pollfd written{terminal_, POLLIN, 0};
    if (poll(&written, 1, 10'000) != 1) return {};
    std::array<char, 4096> buffer{};
    const auto size = read(terminal_, buffer.data(), buffer.size());
    return {buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
  }

 private:
  int terminal_;
  int stderr_;
};

TEST(Progress, EndsTheLineOfABarThatWasInterrupted) {
  const TerminalStderr terminal;
  {
    Progress progress(3, false);
    progress.update(1, "tracked");
    const std::string bar = terminal.text();
    EXPECT_THAT(bar, HasSubstr("[##########....................] 1/3"));
    EXPECT_THAT(bar, EndsWith("tracked"));
  }
  EXPECT_EQ(terminal.text(), "\r\n");  // the terminal adds the carriage return
}

TEST(Progress, EndsTheLineOfAFullBarOnce) {
  const TerminalStderr terminal;
  {
    Progress progress(1, false);
    progress.update(1, "");
    EXPECT_THAT(terminal.text(), EndsWith("s\r\n"));
  }
  static_cast<void>(write(STDERR_FILENO, "end", 3));
  EXPECT_EQ(terminal.text(), "end");
}

TEST(Progress, CountsFramesWhoseNumberIsNotKnown) {
  const TerminalStderr terminal;
  {
    Progress progress(0, false);
    progress.update(1, "tracked");
    const std::string bar = terminal.text();
    EXPECT_THAT(bar, HasSubstr("1  "));
    EXPECT_THAT(bar, EndsWith(" fps  tracked"));
  }
  EXPECT_EQ(terminal.text(), "\r\n");
}

}  // namespace
}  // namespace cvo_slam
