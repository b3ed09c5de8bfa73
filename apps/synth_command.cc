// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/command.h"
#include "cvo_slam/apps/progress.h"
#include "cvo_slam/apps/settings.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/options_file.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"
#include "cvo_slam/synthetic/world_file.h"

namespace cvo_slam {
namespace {

struct SynthArguments {
  std::string folder;
  std::string size = "640x480";
  std::string noise = "none";
  std::string image = "png";
  std::string path = "own";
  std::string dump;
  long frames = 0;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::filesystem::path config;
  std::vector<std::string> settings;  // "key=value" each
  bool dump_config = false;
  synthetic::SequenceOptions sequence;
};

/// Throws OptionError where the text is not "<width>x<height>".
void parse_size(const std::string& text, synthetic::SequenceOptions& options) {
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &options.width, &options.height, &rest) != 2) {
    throw OptionError(fmt::format("--size {} must be <width>x<height>, e.g. 640x480", text));
  }
}

OptionSet describe_sensor(synthetic::SensorOptions& sensor) {
  return OptionSet().add("sensor", describe(sensor));
}

/// The preset, then the configuration file, then each --set: the last one wins.
synthetic::SensorOptions sensor_options(const SynthArguments& arguments) {
  auto sensor = synthetic::sensor_preset(arguments.noise);
  const OptionSet set = describe_sensor(sensor);
  if (!arguments.config.empty()) read_options(arguments.config, set);
  for (const auto& setting : arguments.settings) {
    apply_setting(set, setting, "sensor.depth.axial=0.5");
  }
  return sensor;
}

void parse_path(const std::string& word, synthetic::SequenceOptions& options) {
  for (const auto& [name, style] : synthetic::path_style_names()) {
    if (name == word) options.path = style;
  }
}

std::vector<std::string> path_words() {
  std::vector<std::string> words = {"own"};
  for (const auto& [name, style] : synthetic::path_style_names()) words.push_back(name);
  return words;
}

int dump_world(const SynthArguments& arguments) {
  const auto& options = arguments.sequence;
  const auto world =
      synthetic::make_world(options.scene, {options.seed, options.path, options.speed});
  cvo_slam::write_file(arguments.dump, synthetic::world_text(world));
  fmt::print("{}: {} shapes, path of {:.1f} s\n", arguments.dump, world.scene.primitives.size(),
             world.path.duration());
  return kDone;
}

int synth(SynthArguments arguments, bool frames_given) {
  arguments.sequence.sensor = sensor_options(arguments);
  if (arguments.dump_config) {
    fmt::print("{}", options_to_yaml(describe_sensor(arguments.sequence.sensor), true));
    return kDone;
  }
  parse_path(arguments.path, arguments.sequence);
  if (!arguments.dump.empty()) return dump_world(arguments);
  if (arguments.folder.empty()) {
    throw OptionError("synth: say where to write the sequence, or give --dump-world <file>");
  }
  parse_size(arguments.size, arguments.sequence);
  if (arguments.image == "jpeg") arguments.sequence.image = synthetic::ImageFormat::kJpeg;
  if (frames_given) {
    if (arguments.frames < 1) {
      throw OptionError(fmt::format("--frames {} must be at least 1", arguments.frames));
    }
    arguments.sequence.frames = static_cast<std::size_t>(arguments.frames);
  }
  const auto start = std::chrono::steady_clock::now();
  std::optional<Progress> progress;  // made when the number of frames is known
  const auto report_progress = [&progress](std::size_t done, std::size_t total) {
    if (!progress) progress.emplace(total, false);
    progress->update(done, "");
  };
  const auto summary = synthetic::write_sequence(arguments.folder, arguments.sequence,
                                                 arguments.threads, report_progress);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  fmt::print("{}: {} frames, {:.1f} s, path {:.2f} m, made in {:.1f} s ({:.1f} fps)\n",
             arguments.folder, summary.frames, summary.seconds, summary.path_length,
             elapsed.count(), static_cast<double>(summary.frames) / elapsed.count());
  return kDone;
}

}  // namespace

void add_synth_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<SynthArguments>();
  auto* command =
      app.add_subcommand("synth", "Make a synthetic sequence (TUM layout) with exact ground truth");
  const std::string scenes = fmt::format("{}", fmt::join(synthetic::world_names(), ", "));
  command->add_option(
      "scene", arguments->sequence.scene,
      "The world to record: a file (*.yaml, see docs/reference/synthetic-worlds.md) or one of " +
          scenes);
  command->add_option("folder", arguments->folder, "Where to write the sequence");
  command->add_option("--dump-world", arguments->dump,
                      "Write the world as a file to this place, and record nothing");
  command->add_option("--path", arguments->path, "How the camera moves; own = as the world says")
      ->check(CLI::IsMember(path_words()))
      ->capture_default_str();
  command->add_option("--speed", arguments->sequence.speed, "2 = the same way in half the time")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
  const auto* frames =
      command->add_option("--frames", arguments->frames,
                          "Only the first n frames at the same speed (default: the whole path)");
  command
      ->add_option(
          "--seed", arguments->sequence.seed,
          "Of textures, clutter, the hand's tremor and, with sensor.seed, the sensor's noise")
      ->capture_default_str();
  const std::string presets = fmt::format("{}", fmt::join(synthetic::sensor_preset_names(), ", "));
  command->add_option("--noise", arguments->noise, "The sensor to start from: " + presets)
      ->capture_default_str();
  command->add_option("--config", arguments->config,
                      "YAML file of the sensor's options; see --dump-config");
  command
      ->add_option("--set", arguments->settings,
                   "An option of the sensor, as key=value; may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--dump-config", arguments->dump_config,
                    "Print the sensor's options as YAML with their documentation, and end");
  command->add_option("--size", arguments->size, "Image size, <width>x<height> [px]")
      ->capture_default_str();
  command->add_option("--image", arguments->image, "Colour images: png (exact) or jpeg (smaller)")
      ->check(CLI::IsMember({"png", "jpeg"}))
      ->capture_default_str();
  command->add_option("--threads", arguments->threads, "Does not change the result")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->callback([&action, arguments, frames] {
    const bool frames_given = frames->count() > 0;
    action = [arguments, frames_given] { return synth(*arguments, frames_given); };
  });
}

}  // namespace cvo_slam
