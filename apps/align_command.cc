// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/apps/frame_pair.h"
#include "cvo_slam/apps/frame_registration.h"
#include "cvo_slam/apps/registration_plots.h"
#include "cvo_slam/apps/report_json.h"
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
  const TrackerOptions options = arguments.options.options().slam.tracker;
  const FramePair pair = read_frame_pair(arguments.inputs, arguments.camera);
  // Made before the work, so that an unusable folder is reported at once.
  if (!arguments.plot.empty()) make_folder(arguments.plot);
  const FrameRegistration registration = register_frames(pair, options);
  if (!arguments.plot.empty()) {
    write_registration_plots(arguments.plot, pair, registration, options.registration);
  }
  fmt::print("{}",
             arguments.json ? json_text(pair, registration) + "\n" : to_table(pair, registration));
  return registration.rejection.empty() ? kDone : kTrackingLost;
}

}  // namespace

void add_align_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<AlignArguments>();
  Command command(app, "align", "Register two frames: the motion between them and its uncertainty");
  command
      .add("inputs", &arguments->inputs,
           "Folder of a sequence and two of its frames, each a number or a stamp (with a point); "
           "or four images: colour and depth of a, colour and depth of b")
      .required();
  command.add("--camera", &arguments->camera,
              "Camera file, or name of a built-in camera (default: the camera of the sequence)");
  arguments->options.add_to(command);
  command.add("--plot", &arguments->plot,
              "Folder for pictures (PNG and SVG): registration shows both frames before and after "
              "beside the kernel matrix, step the objective along the first step of the flow");
  command.add("--json", &arguments->json, "Print one JSON object instead of a table");
  command.on_parsed(action, [arguments] { return align_frames(*arguments); });
}

}  // namespace cvo_slam
