// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/command.h"

namespace cvo_slam {

void add_commands(CLI::App& app, Action& action) {
  add_run_command(app, action);
  add_eval_command(app, action);
  add_align_command(app, action);
  add_info_command(app, action);
  add_synth_command(app, action);
  add_optimize_command(app, action);
  add_vocab_command(app, action);
  add_render_command(app, action);
  add_bench_command(app, action);
}

}  // namespace cvo_slam
