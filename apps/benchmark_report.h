// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cvo_slam/apps/odometry_benchmark.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// How the figures are measured, in one line.
[[nodiscard]] std::string_view benchmark_protocol();

/// Returns the frames, the sequence and the protocol as a list, and a table with a row for each
/// system, in Markdown that is aligned to be read as it is. A figure that does not exist is "-".
[[nodiscard]] std::string to_table(const Dataset& data, const OdometryBenchmark& benchmark);

/// Writes odometry.{png,svg} into the folder: distributions of the errors from frame to frame, and
/// top views, of the systems that are built in. Throws DataError if the sequence has no reference
/// for these frames, OutputError if a file cannot be written.
void write_benchmark_plots(const std::filesystem::path& folder, const Dataset& data,
                           const OdometryBenchmark& benchmark);

}  // namespace cvo_slam
