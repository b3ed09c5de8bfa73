// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// Reads a trajectory in TUM format: "stamp tx ty tz qx qy qz qw" a line, '#' starts a comment.
/// Throws InputError with the line number for a wrong number of values, a value that is not finite,
/// a quaternion of zero length, or stamps out of order or duplicated.
[[nodiscard]] std::vector<StampedPose> read_tum(const std::filesystem::path& file);

/// As read_tum(), but for files as they are found: poses out of order are sorted, the later ones of
/// equal stamps dropped, and `notes` says so.
[[nodiscard]] std::vector<StampedPose> read_tum_in_any_order(const std::filesystem::path& file,
                                                             std::vector<std::string>& notes);

/// Writes a trajectory in TUM format, a line a frame; a frame without a pose becomes a comment line
/// "# lost <stamp> <reason>". Throws OutputError.
void write_tum(const std::filesystem::path& file, const Trajectory& trajectory);

}  // namespace cvo_slam
