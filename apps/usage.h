// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace cvo_slam {

/// What is wrong with a command line that `app` could not parse, in one line: the problem, the
/// nearest name where one is unknown, and whose help page to read.
[[nodiscard]] std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace cvo_slam
