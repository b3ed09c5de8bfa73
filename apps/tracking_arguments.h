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

#include "cvo_slam/core/map.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// The options of the program, as a configuration file holds them.
struct ProgramOptions {
  TrackerOptions tracker;
  SlamOptions slam;
  FusionOptions map;
};

[[nodiscard]] OptionSet describe(ProgramOptions& options);

/// The frames begin, begin + step, ... below end of a sequence.
struct FrameRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t step = 1;

  [[nodiscard]] std::size_t size() const { return (end - begin + step - 1) / step; }
};

/// Where a command's options come from.
struct OptionArguments {
  std::string preset;
  std::filesystem::path config;
  std::vector<std::string> settings;  ///< "key=value" each
  std::optional<int> threads;
  std::string simd = "best";

  /// Declares them on a subcommand.
  void add_to(CLI::App& command);

  /// The preset, then the configuration file, then each --set, then --threads: the last one wins.
  /// Pins the SIMD path.
  [[nodiscard]] ProgramOptions options() const;
};

/// What `run` and `bench` have in common on the command line: which frames of which sequence, and
/// with which options.
struct TrackingArguments : OptionArguments {
  std::filesystem::path dataset;
  std::string camera;  ///< file or built-in name; empty = the sequence's own
  std::string frames;  ///< "a:b", "a:", ":b" or "a:b:step"; empty = all

  /// Declares the options on a subcommand.
  void add_to(CLI::App& command);

  /// Throws InputError where the sequence cannot be opened.
  [[nodiscard]] std::unique_ptr<Dataset> open() const;
  /// Throws OptionError where the range is malformed or empty for a sequence of `size` frames.
  [[nodiscard]] FrameRange range(std::size_t size) const;
};

}  // namespace cvo_slam
