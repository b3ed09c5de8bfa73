// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <exception>

#include <fmt/format.h>

namespace cvo_slam {

/// Runs the body of a program's main() and returns its exit code: 0, or 2 after an error, of which
/// one line is printed.
template <typename Body>
int report_errors(const Body& body) {
  try {
    body();
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}

}  // namespace cvo_slam
