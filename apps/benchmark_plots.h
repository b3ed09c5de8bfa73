// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "cvo_slam/apps/odometry_benchmark.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// Cumulative distributions of the errors frame to frame by the CVO paper's measure, and top views,
/// of the systems that are built in. Unlike the table's, these errors are against the reference
/// interpolated at the frames' stamps: between two frames the distance to the nearest sample is as
/// large as the motion. Throws DataError where the sequence has no reference for these frames.
[[nodiscard]] Figure benchmark_figure(const Dataset& data, const OdometryBenchmark& benchmark);

/// Writes it as odometry.{png,svg} into the folder. Throws OutputError, and as above.
void write_benchmark_plots(const std::filesystem::path& folder, const Dataset& data,
                           const OdometryBenchmark& benchmark);

}  // namespace cvo_slam
