// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/argument_text.h"
#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/apps/progress.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/options_file.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam {
namespace {

struct SynthArguments {
  std::string folder;
  std::string size = "640x480";
  std::string noise = "none";
  std::string image = "png";
  std::string path = "own";
  std::string dump;
  std::optional<int> frames;     // empty = the whole path
  std::optional<int> path_seed;  // empty = the path as it is
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::filesystem::path config;
  std::vector<std::string> settings;  // "key=value" each
  bool dump_config = false;
  synthetic::SequenceOptions sequence;
};

OptionSet describe_sensor(synthetic::SensorOptions& sensor) {
  return OptionSet().add("sensor", describe(sensor));
}

/// Returns the preset, changed by the configuration file and then by each --set: the last one wins.
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
  const auto world = synthetic::make_world(options.scene, {.seed = options.seed,
                                                           .path_seed = options.path_seed,
                                                           .style = options.path,
                                                           .speed = options.speed});
  cvo_slam::write_file(arguments.dump, synthetic::world_text(world));
  fmt::print("{}: {} shapes, path of {:.1f} s\n", arguments.dump, world.scene.primitives.size(),
             world.path.duration());
  return kDone;
}

int synth(SynthArguments arguments) {
  arguments.sequence.sensor = sensor_options(arguments);
  if (arguments.dump_config) {
    fmt::print("{}", options_to_yaml(describe_sensor(arguments.sequence.sensor), true));
    return kDone;
  }
  parse_path(arguments.path, arguments.sequence);
  if (arguments.path_seed) {
    arguments.sequence.path_seed = static_cast<std::uint32_t>(*arguments.path_seed);
  }
  if (!arguments.dump.empty()) return dump_world(arguments);
  if (arguments.folder.empty()) {
    throw OptionError("synth: say where to write the sequence, or give --dump-world <file>");
  }
  const PixelSize size = parse_size(arguments.size, "640x480");
  arguments.sequence.width = size.width;
  arguments.sequence.height = size.height;
  if (arguments.image == "jpeg") arguments.sequence.image = synthetic::ImageFormat::kJpeg;
  if (arguments.frames) {
    if (*arguments.frames < 1) {
      throw OptionError(fmt::format("--frames {} must be at least 1", *arguments.frames));
    }
    arguments.sequence.frames = static_cast<std::size_t>(*arguments.frames);
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
  Command command(app, "synth", "Make a synthetic sequence (TUM layout) with exact ground truth");
  command.add("scene", &arguments->sequence.scene,
              fmt::format("The world to record: a file (*.yaml, see "
                          "docs/reference/synthetic-worlds.md) or one of {}",
                          fmt::join(synthetic::world_names(), ", ")));
  command.add("folder", &arguments->folder, "Folder for the sequence");
  command.add("--dump-world", &arguments->dump, "Write the world to this file, and record nothing");
  command.add("--path", &arguments->path, "How the camera moves; own = as the world says")
      .one_of(path_words())
      .show_default();
  command
      .add("--speed", &arguments->sequence.speed,
           "Factor on the speed of the camera: with 2 the path takes half the time")
      .in_range(0.01, 100.0)
      .show_default();
  command.add("--frames", &arguments->frames,
              "Only the first n frames at the same speed (default: the whole path)");
  command
      .add("--seed", &arguments->sequence.seed,
           "Seed of textures, clutter and the tremor of the hand and, with sensor.seed, of the "
           "noise of the sensor")
      .show_default();
  command.add(
      "--path-seed", &arguments->path_seed,
      "Seed of another walk through the same world: another tremor, and viewpoints moved by "
      "up to 0.1 m (default: the path as it is, with the tremor of --seed)");
  command
      .add("--laps", &arguments->sequence.laps,
           "Number of rounds of the whole path; --frames goes before it")
      .in_range(1, 1000)
      .show_default();
  command
      .add("--noise", &arguments->noise,
           fmt::format("The sensor to start from: {}",
                       fmt::join(synthetic::sensor_preset_names(), ", ")))
      .show_default();
  command.add("--config", &arguments->config,
              "YAML file of the options of the sensor; --dump-config prints one");
  command
      .add("--set", &arguments->settings, "One option of the sensor as key=value; may be repeated")
      .one_value_each();
  command.add("--dump-config", &arguments->dump_config,
              "Print the options of the sensor as YAML with their documentation, and stop");
  command.add("--size", &arguments->size, "Size of the images, <width>x<height> [px]")
      .show_default();
  command
      .add("--image", &arguments->image, "Format of colour images: png (exact) or jpeg (smaller)")
      .one_of({"png", "jpeg"})
      .show_default();
  command
      .add("--threads", &arguments->threads, "Number of threads; the result does not depend on it")
      .in_range(1, 1024)
      .show_default();
  command.on_parsed(action, [arguments] { return synth(*arguments); });
}

}  // namespace cvo_slam
