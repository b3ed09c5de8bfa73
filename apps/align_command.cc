// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/command.h"
#include "cvo_slam/apps/frame_pair.h"
#include "cvo_slam/apps/frame_registration.h"
#include "cvo_slam/apps/registration_plots.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/core/files.h"

namespace cvo_slam {
namespace {

struct AlignArguments {
  std::vector<std::string> inputs;
  OptionArguments options;
  std::string camera;
  std::filesystem::path plot;
  bool json = false;
};

int align_frames(const AlignArguments& arguments) {
  const TrackerOptions options = arguments.options.options().tracker;
  const FramePair pair = read_frame_pair(arguments.inputs, arguments.camera);
  // Before the work, so that an unusable folder is known at once.
  if (!arguments.plot.empty()) make_folder(arguments.plot);
  const FrameRegistration registration = register_frames(pair, options);
  if (!arguments.plot.empty()) {
    write_registration_plots(arguments.plot, pair, registration, options.registration);
  }
  fmt::print("{}", arguments.json ? to_json(pair, registration).dump(2) + "\n"
                                  : to_table(pair, registration));
  return registration.doubt.empty() ? kDone : kTrackingLost;
}

}  // namespace

void add_align_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<AlignArguments>();
  auto* command = app.add_subcommand(
      "align", "Register two frames: the motion between them, and how sure it is");
  command
      ->add_option("inputs", arguments->inputs,
                   "Folder of a sequence and two of its frames, each a number or a stamp (with a "
                   "point); or four images: colour and depth of a, colour and depth of b")
      ->required();
  command->add_option("--camera", arguments->camera,
                      "Camera file, or name of a built-in camera (default: the sequence's own)");
  arguments->options.add_to(*command);
  command->add_option("--plot", arguments->plot,
                      "Folder for pictures (png and svg): registration, both frames before and "
                      "after beside the kernel matrix; step, the objective along the flow's first "
                      "step");
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command->callback(
      [&action, arguments] { action = [arguments] { return align_frames(*arguments); }; });
}

}  // namespace cvo_slam
