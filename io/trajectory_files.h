// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// Reads a trajectory in TUM format: lines "stamp tx ty tz qx qy qz qw", with blanks, commas or
/// semicolons between the values; '#' starts a comment. Of successive poses with the same stamp the
/// first is kept: the motion capture of the benchmark itself has such lines (fr2/desk). Throws
/// InputError with the line for a wrong number of values, a value that is not finite, a quaternion
/// of length zero, or stamps out of order. For files that this library wrote;
/// read_foreign_tum() is for others.
[[nodiscard]] std::vector<StampedPose> read_tum(const std::filesystem::path& file);

/// Number of lines of a trajectory file that were left out.
struct LeftOutLines {
  std::size_t repeated = 0;  ///< the stamp is that of an earlier line
  /// A value is not finite (or beyond 1e100), or the quaternion has length zero: what some programs
  /// write for a frame without a pose.
  std::size_t invalid = 0;

  /// Returns the number of all lines that were left out.
  [[nodiscard]] std::size_t total() const { return repeated + invalid; }
};

/// A trajectory as another program wrote it.
struct ForeignTrajectory {
  std::vector<StampedPose> poses;  ///< in ascending order of stamps, none twice
  LeftOutLines left_out;           ///< lines that gave no pose
  bool sorted = false;             ///< true if the lines of the file are not in that order
  /// One line for each kind of line that was left out, and one if stamps were out of order. They
  /// begin with the name of the file.
  std::vector<std::string> notes;
};

/// Reads a trajectory like read_tum(), but accepts stamps in any order, and leaves out and counts
/// lines whose stamp was there before and lines without a valid pose. Throws InputError with the
/// line for one that is no line of eight numbers.
[[nodiscard]] ForeignTrajectory read_foreign_tum(const std::filesystem::path& file);

/// Returns the poses of read_foreign_tum() and appends its notes to `notes`.
[[nodiscard]] std::vector<StampedPose> read_tum_in_any_order(const std::filesystem::path& file,
                                                             std::vector<std::string>& notes);

/// Writes a trajectory in TUM format, one line per frame; a frame without a pose is a comment line
/// `# lost <stamp> <reason>`. Throws OutputError.
void write_tum(const std::filesystem::path& file, const Trajectory& trajectory);

}  // namespace cvo_slam
