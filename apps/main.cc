// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include <fcntl.h>

#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

int fail(ExitCode code, const char* problem) {
  std::fprintf(stderr, "cvo_slam: error: %s\n", problem);
  return code;
}

/// Returns the code, or kFailed if what was printed did not arrive: a full disk shows at the last
/// flush.
int after_flush(int code) {
  const bool arrived = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  return arrived ? code : fail(kFailed, "stdout cannot be written; check free space");
}

/// Keeps hours of work alive if a reader goes away or the caller closed a stream.
void secure_standard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  for (const int stream : {0, 1, 2}) {
    // Otherwise the next file to be opened would get the stream's number, and its text. Read-only,
    // so that a closed stdout is still an error.
    if (fcntl(stream, F_GETFD) == -1) open("/dev/null", O_RDONLY | O_CLOEXEC);
  }
}

}  // namespace
}  // namespace cvo_slam

int main(int argc, char** argv) {
  using namespace cvo_slam;
  try {
    secure_standard_streams();
    return after_flush(parse_command_line(argc, argv)());
  } catch (const InputError& error) {
    return fail(kBadInput, error.what());
  } catch (const OptionError& error) {
    return fail(kBadInput, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kFailed,
                "memory is used up; take fewer frames (--frames), smaller images, or --no-map");
  } catch (const std::exception& error) {
    return fail(kFailed, error.what());
  }
}
