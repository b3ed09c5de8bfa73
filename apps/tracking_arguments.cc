// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/tracking_arguments.h"

#include <system_error>

#include <fmt/format.h>

#include "cvo_slam/apps/argument_text.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/frontend/simd.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/options_file.h"

namespace cvo_slam {
namespace {

std::vector<std::string> simd_words() {
  std::vector<std::string> words;
  for (const auto& [word, path] : simd_path_names()) words.push_back(word);
  return words;
}

void pin_simd_path(const std::string& word) {
  for (const auto& [name, path] : simd_path_names()) {
    if (name == word) pin_simd(path);
  }
}

}  // namespace

OptionSet describe(ProgramOptions& o) {
  return OptionSet().add(describe(o.slam)).add("map", describe(o.map));
}

void OptionArguments::add_to(Command& command) {
  command.add("--preset", &preset, "Options to start from; paper = the protocol of the CVO paper")
      .one_of({"paper"});
  command.add("--config", &config, "YAML file of options; run --dump-config prints one");
  command.add("--set", &settings, "One option as key=value; may be repeated").one_value_each();
  command.add("--threads", &threads, "Threads of a registration; the result does not depend on it")
      .in_range(1, 1024);
  command.add("--simd", &simd, "Instruction set to compute with")
      .one_of(simd_words())
      .show_default();
}

void DatasetArguments::add_to(Command& command) {
  command.add("dataset", &dataset, "Folder of a sequence: " + dataset_formats());
  command.add("--camera", &camera,
              "Camera file, or name of a built-in camera (default: the camera of the sequence)");
  command.add("--associations", &associations,
              "File of lines 'stamp file stamp file' that pairs the images, paths relative to the "
              "folder of the sequence");
  command.add("--max-diff", &options.max_stamp_difference,
              "Largest difference between the stamps of a colour and a depth image that make a "
              "frame [s] (default 0.02)");
  command
      .add("--frame-rate", &options.frame_rate,
           "Frames a second of a recording whose images are numbered and have no stamps [Hz] "
           "(default: 30, or less if the images say so)")
      .in_range(0.01, 1000.0);
  command
      .add(
          "--depth-offset", &depth_offset,
          "Time to add to the stamps of the depth images [s]; auto = that of the camera file, else "
          "measured if colour and depth have different stamps; measure = always measured")
      .show_default();
}

std::optional<double> DatasetArguments::given_depth_offset() const {
  if (depth_offset == kAutomaticDepthOffset || depth_offset == kMeasuredDepthOffset) {
    return std::nullopt;
  }
  const auto seconds = parse_finite(depth_offset);
  if (seconds) return seconds;
  throw OptionError(fmt::format("--depth-offset '{}': expected seconds, {} or {}", depth_offset,
                                kAutomaticDepthOffset, kMeasuredDepthOffset));
}

DatasetOptions DatasetArguments::dataset_options(const std::optional<double>& offset) const {
  if (dataset.empty()) throw OptionError("no dataset given: name the folder of a sequence");
  DatasetOptions chosen = options;
  if (!camera.empty()) chosen.camera = find_camera(camera);
  if (!associations.empty()) chosen.associations = associations;
  chosen.depth_offset = offset ? offset : given_depth_offset();
  return chosen;
}

std::unique_ptr<Dataset> DatasetArguments::open(const std::optional<double>& offset) const {
  const DatasetOptions chosen = dataset_options(offset);  // first: it may refuse
  return open_dataset(dataset, chosen);
}

void TrackingArguments::add_to(Command& command) {
  sequence.add_to(command);
  command.add("--frames", &frames,
              "Only frames a to b-1, as a:b, a: or :b; every n-th of them as a:b:n");
  OptionArguments::add_to(command);
}

ProgramOptions OptionArguments::options() const {
  pin_simd_path(simd);
  ProgramOptions result;
  if (preset == "paper") result.slam.tracker = paper_options();
  const OptionSet set = describe(result);
  if (!config.empty()) read_options(config, set);
  for (const auto& setting : settings) apply_setting(set, setting, "tracker.points=2000");
  if (threads) result.slam.tracker.threads = *threads;
  return result;
}

}  // namespace cvo_slam
