// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "cvo_slam/core/options.h"

namespace cvo_slam {

/// Sets the options that a YAML file names; keys of nested maps are joined by dots. Throws
/// InputError with file and line if the file is not YAML, or has an unknown option (the message
/// names the nearest one) or a bad value.
void read_options(const std::filesystem::path& file, const OptionSet& options);

/// Returns all options as YAML text that read_options() accepts; with `comments` each option is
/// preceded by its documentation, unit and range.
[[nodiscard]] std::string options_to_yaml(const OptionSet& options, bool comments = false);

}  // namespace cvo_slam
