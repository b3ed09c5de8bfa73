// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "cvo_slam/core/options.h"

namespace cvo_slam {

/// Sets the options that a YAML file names (nested maps = dotted keys). Throws InputError with file
/// and line for unreadable YAML, an unknown key (with the nearest name) or a bad value.
void read_options(const std::filesystem::path& file, const OptionSet& options);

/// All options as YAML text that read_options() accepts; with `comments` each is preceded by its
/// documentation, unit and range.
[[nodiscard]] std::string options_to_yaml(const OptionSet& options, bool comments = false);

}  // namespace cvo_slam
