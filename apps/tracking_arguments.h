// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cvo_slam/apps/argument_text.h"
#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// The options of the program, as a configuration file holds them.
struct ProgramOptions {
  SlamOptions slam;
  FusionOptions map;
};

/// Returns the options with their keys and documentation.
[[nodiscard]] OptionSet describe(ProgramOptions& options);

/// The arguments that a command's options come from.
struct OptionArguments {
  std::string preset;
  std::filesystem::path config;
  std::vector<std::string> settings;  ///< "key=value" each
  std::optional<int> threads;
  std::string simd = "best";

  /// Declares them on a subcommand.
  void add_to(Command& command);

  /// Returns the preset, changed by the configuration file, then by each --set, then by --threads:
  /// the last one wins. Pins the SIMD path of the process.
  [[nodiscard]] ProgramOptions options() const;
};

/// What --depth-offset can be besides a number: measured if the stamps of colour and depth differ
/// and the camera does not say it, or measured in any case.
inline constexpr const char* kAutomaticDepthOffset = "auto";
inline constexpr const char* kMeasuredDepthOffset = "measure";

/// The arguments that say which sequence is read, and how.
struct DatasetArguments {
  std::filesystem::path dataset;
  std::string camera;                  ///< file or built-in name; empty = the one of the sequence
  std::filesystem::path associations;  ///< empty = those of the sequence
  std::string depth_offset = kAutomaticDepthOffset;  ///< or "measure", or seconds
  DatasetOptions options;

  /// Declares them on a subcommand. The folder is the first positional argument.
  void add_to(Command& command);

  /// True if the images are named on standard input.
  [[nodiscard]] bool is_pipe() const { return dataset == "-"; }
  /// Returns the depth offset if --depth-offset is a number [s]. Throws OptionError if it is none
  /// of the words.
  [[nodiscard]] std::optional<double> given_depth_offset() const;

  /// Returns the options to open the sequence with, and with a depth offset; empty = the one given,
  /// else that of the camera. Throws OptionError if no sequence is given.
  [[nodiscard]] DatasetOptions dataset_options(
      const std::optional<double>& offset = std::nullopt) const;
  /// Opens the sequence with these options. Throws InputError if that fails.
  [[nodiscard]] std::unique_ptr<Dataset> open(
      const std::optional<double>& offset = std::nullopt) const;
};

/// The arguments that `run` and `bench` share: which frames of which sequence, with which options.
struct TrackingArguments : OptionArguments {
  DatasetArguments sequence;
  std::string frames;  ///< "a:b", "a:", ":b" or "a:b:step"; empty = all

  /// Declares the options on a subcommand.
  void add_to(Command& command);

  /// Returns the frames to use of a sequence of `size` frames. Throws OptionError.
  [[nodiscard]] FrameRange range(std::size_t size) const { return parse_frames(frames, size); }
};

}  // namespace cvo_slam
