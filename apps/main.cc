// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include <fcntl.h>

#include "cvo_slam/apps/command.h"
#include "cvo_slam/apps/usage.h"
#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

int fail(ExitCode code, const char* problem) {
  std::fprintf(stderr, "cvo_slam: error: %s\n", problem);
  return code;
}

/// The code, or kFailed where what was printed did not arrive: a full disk shows at the last flush.
int after_flush(int code) {
  const bool arrived = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  return arrived ? code : fail(kFailed, "stdout cannot be written; check free space");
}

/// A reader that went away or a stream that the caller closed must not end hours of work.
void secure_standard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  for (const int stream : {0, 1, 2}) {
    // Else the next file to be opened would get its number, and its text. Read-only, so that a
    // closed stdout is still an error.
    if (fcntl(stream, F_GETFD) == -1) open("/dev/null", O_RDONLY | O_CLOEXEC);
  }
}

int parse_and_run(int argc, char** argv) {
  CLI::App app{"cvo_slam: RGB-D SLAM with Continuous Visual Odometry", "cvo_slam"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "cvo_slam " CVO_SLAM_VERSION);
  Action action;
  add_commands(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& page) {
    return after_flush(app.exit(page));  // prints the help page or the version
  } catch (const CLI::ParseError& error) {
    return fail(kBadInput, usage_message(app, error).c_str());
  }
  return after_flush(action());
}

}  // namespace
}  // namespace cvo_slam

int main(int argc, char** argv) {
  using namespace cvo_slam;
  try {
    secure_standard_streams();
    return parse_and_run(argc, argv);
  } catch (const InputError& error) {
    return fail(kBadInput, error.what());
  } catch (const OptionError& error) {
    return fail(kBadInput, error.what());
  } catch (const std::exception& error) {
    return fail(kFailed, error.what());
  }
}
