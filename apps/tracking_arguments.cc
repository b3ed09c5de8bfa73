// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/tracking_arguments.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "cvo_slam/apps/settings.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/simd.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/options_file.h"

namespace cvo_slam {
namespace {

/// One end of a range; `otherwise` where the text is empty.
std::optional<std::size_t> parse_end(std::string_view text, std::size_t otherwise) {
  if (text.empty()) return otherwise;
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

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
  return OptionSet()
      .add("tracker", describe(o.tracker))
      .add("slam", describe(o.slam))
      .add("map", describe(o.map));
}

void OptionArguments::add_to(CLI::App& command) {
  command.add_option("--preset", preset, "Options to start from; paper = the CVO paper's protocol")
      ->check(CLI::IsMember({"paper"}));
  command.add_option("--config", config, "YAML file of options; see --dump-config of run");
  command.add_option("--set", settings, "An option, as key=value; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--threads", threads, "Threads of a registration; does not change the result")
      ->check(CLI::Range(1, 1024));
  command.add_option("--simd", simd, "Instruction set to compute with")
      ->check(CLI::IsMember(simd_words()))
      ->capture_default_str();
}

void TrackingArguments::add_to(CLI::App& command) {
  command.add_option("dataset", dataset, "Folder of a sequence: " + dataset_formats());
  command.add_option("--camera", camera,
                     "Camera file, or name of a built-in camera (default: the sequence's own)");
  command.add_option("--frames", frames,
                     "Only frames a to b-1, as a:b, a: or :b; every n-th of them as a:b:n");
  OptionArguments::add_to(command);
}

std::unique_ptr<Dataset> TrackingArguments::open() const {
  if (dataset.empty()) throw OptionError("no dataset given: name the folder of a sequence");
  DatasetOptions dataset_options;
  if (!camera.empty()) dataset_options.camera = find_camera(camera);
  return open_dataset(dataset, dataset_options);
}

ProgramOptions OptionArguments::options() const {
  pin_simd_path(simd);
  ProgramOptions result;
  if (preset == "paper") result.tracker = paper_options();
  const OptionSet set = describe(result);
  if (!config.empty()) read_options(config, set);
  for (const auto& setting : settings) apply_setting(set, setting, "tracker.points=2000");
  if (threads) result.tracker.threads = *threads;
  return result;
}

FrameRange TrackingArguments::range(std::size_t size) const {
  if (frames.empty()) return {0, size};
  const std::string_view text = frames;
  const std::size_t colon = text.find(':');
  const std::size_t second = colon == std::string_view::npos ? colon : text.find(':', colon + 1);
  const auto part = [&](std::size_t first, std::size_t last) {
    return first == 0 ? std::string_view() : text.substr(first, last - first);
  };
  const auto begin = parse_end(text.substr(0, colon), 0);
  const auto end = parse_end(part(colon + 1, second), size);
  const auto step = parse_end(part(second + 1, text.size()), 1);
  if (colon == std::string_view::npos || !begin || !end || !step || *step == 0) {
    throw OptionError(
        fmt::format("--frames {} must be a:b, a:, :b or a:b:step, e.g. 0:100", frames));
  }
  const FrameRange range{*begin, std::min(*end, size), *step};
  if (range.begin >= range.end) {
    throw OptionError(fmt::format("--frames {} holds no frame; the sequence has frames 0 to {}",
                                  frames, size - 1));
  }
  return range;
}

}  // namespace cvo_slam
