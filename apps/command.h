// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace cvo_slam {

/// What a parsed subcommand does; the result is the exit code of the program.
using Action = std::function<int()>;

/// Exit codes of the program (docs/architecture.md, "The command line").
enum ExitCode : int {
  kDone = 0,
  kFailed = 1,
  kBadInput = 2,
  kTrackingLost = 3,
  kInterrupted = 130,
};

// Each add_<name>_command() declares one subcommand and its options on `app`; `action` is set when
// the command line names it.

void add_run_command(CLI::App& app, Action& action);
void add_eval_command(CLI::App& app, Action& action);
void add_align_command(CLI::App& app, Action& action);
void add_info_command(CLI::App& app, Action& action);
void add_synth_command(CLI::App& app, Action& action);
void add_optimize_command(CLI::App& app, Action& action);
void add_vocab_command(CLI::App& app, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_bench_command(CLI::App& app, Action& action);

/// All of them, in the order of the help page.
void add_commands(CLI::App& app, Action& action);

}  // namespace cvo_slam
