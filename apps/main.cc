// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>
#include <string>

#include "cvo_slam/apps/command.h"
#include "cvo_slam/apps/usage.h"
#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

int fail(ExitCode code, const std::string& problem) {
  std::fprintf(stderr, "cvo_slam: error: %s\n", problem.c_str());
  return code;
}

int main(int argc, char** argv) {
  CLI::App app{"cvo_slam: RGB-D SLAM with Continuous Visual Odometry", "cvo_slam"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "cvo_slam " CVO_SLAM_VERSION);
  Action action;
  add_commands(app, action);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& page) {
    return app.exit(page);  // prints the help page or the version
  } catch (const CLI::ParseError& error) {
    return fail(kBadInput, usage_message(app, error));
  }
  try {
    return action();
  } catch (const InputError& error) {
    return fail(kBadInput, error.what());
  } catch (const OptionError& error) {
    return fail(kBadInput, error.what());
  } catch (const std::exception& error) {
    return fail(kFailed, error.what());
  }
}

}  // namespace
}  // namespace cvo_slam

int main(int argc, char** argv) { return cvo_slam::main(argc, argv); }
