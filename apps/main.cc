// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>

#include "cvo_slam/apps/command.h"
#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

int fail(ExitCode code, const std::exception& error) {
  std::fprintf(stderr, "cvo_slam: error: %s\n", error.what());
  return code;
}

int main(int argc, char** argv) {
  CLI::App app{"cvo_slam: RGB-D SLAM with Continuous Visual Odometry", "cvo_slam"};
  app.require_subcommand(1);
  Action action;
  add_commands(app, action);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // CLI11 prints the help text; for an error it would print two lines.
    if (error.get_exit_code() == 0) return app.exit(error);
    return fail(kBadInput, error);
  }
  try {
    return action();
  } catch (const InputError& error) {
    return fail(kBadInput, error);
  } catch (const OptionError& error) {
    return fail(kBadInput, error);
  } catch (const std::exception& error) {
    return fail(kFailed, error);
  }
}

}  // namespace
}  // namespace cvo_slam

int main(int argc, char** argv) { return cvo_slam::main(argc, argv); }
