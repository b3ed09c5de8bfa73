// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// Reads a trajectory in TUM format: lines "stamp tx ty tz qx qy qz qw"; '#' starts a comment. Of
/// successive poses with the same stamp the first is kept: the motion capture of the benchmark
/// itself has such lines (fr2/desk). Throws InputError with the line for a wrong number of values,
/// a value that is not finite, a quaternion of length zero, or stamps out of order.
[[nodiscard]] std::vector<StampedPose> read_tum(const std::filesystem::path& file);

/// Reads a trajectory like read_tum(), but accepts stamps in any order: poses are sorted, of equal
/// stamps the first is kept, and a line about it is added to `notes`.
[[nodiscard]] std::vector<StampedPose> read_tum_in_any_order(const std::filesystem::path& file,
                                                             std::vector<std::string>& notes);

/// Writes a trajectory in TUM format, one line per frame; a frame without a pose is a comment line
/// "# lost <stamp> <reason>". Throws OutputError.
void write_tum(const std::filesystem::path& file, const Trajectory& trajectory);

}  // namespace cvo_slam
