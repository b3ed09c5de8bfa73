// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/trajectory_files.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

/// The eight numbers of a line: stamp, position, quaternion.
using PoseNumbers = std::array<double, 8>;

/// Throws InputError if the line is not one of eight numbers; they need not be finite.
PoseNumbers parse_pose_numbers(const TextLine& line, const std::filesystem::path& file) {
  PoseNumbers numbers{};
  if (line.words.size() != numbers.size()) {
    throw InputError(file, line.number,
                     fmt::format("expected 8 values 'stamp tx ty tz qx qy qz qw', found {}; "
                                 "convert the file to this format",
                                 line.words.size()));
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = parse_number(line.words[i]);
    if (!number && i == 0) static_cast<void>(parse_stamp(line, 0, file));  // throws
    if (!number) throw InputError(file, line.number, number_problem(line.words[i]));
    numbers[i] = *number;
  }
  return numbers;
}

/// Returns why the numbers are no pose; an empty text if they are one.
std::string pose_problem(const TextLine& line, const PoseNumbers& numbers) {
  // The squares of larger numbers would not be finite.
  constexpr double kLargest = 1e100;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::fabs(numbers[i]) <= kLargest) continue;
    return number_problem(line.words[i]);
  }
  if (Eigen::Vector4d(numbers[4], numbers[5], numbers[6], numbers[7]).squaredNorm() < 1e-12) {
    return "the quaternion has length zero; repair or remove the line";
  }
  return {};
}

StampedPose to_stamped_pose(const TextLine& line, const PoseNumbers& numbers,
                            const std::filesystem::path& file) {
  const auto& [seconds, tx, ty, tz, qx, qy, qz, qw] = numbers;
  static_cast<void>(seconds);  // the stamp keeps the digits of the file
  return {parse_stamp(line, 0, file), SE3::from_quaternion(qx, qy, qz, qw, {tx, ty, tz})};
}

std::string format_line(const StampedPose& pose) {
  const Vector3& t = pose.T_world_camera.translation();
  const Eigen::Vector4d q = pose.T_world_camera.quaternion();
  return fmt::format("{} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f}\n",
                     pose.stamp.to_string(), t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
}

}  // namespace

std::vector<StampedPose> read_tum(const std::filesystem::path& file) {
  std::vector<StampedPose> poses;
  for (const auto& line : read_word_lines(file)) {
    const PoseNumbers numbers = parse_pose_numbers(line, file);
    const std::string problem = pose_problem(line, numbers);
    if (!problem.empty()) throw InputError(file, line.number, problem);
    const StampedPose pose = to_stamped_pose(line, numbers, file);
    if (!poses.empty() && poses.back().stamp == pose.stamp) continue;
    if (!poses.empty() && pose.stamp < poses.back().stamp) {
      throw InputError(
          file, line.number,
          fmt::format("stamp {} is before the one above it; sort the file by time", line.words[0]));
    }
    poses.push_back(pose);
  }
  return poses;
}

ForeignTrajectory read_foreign_tum(const std::filesystem::path& file) {
  ForeignTrajectory trajectory;
  const std::vector<TextLine> lines = read_word_lines(file);
  for (const auto& line : lines) {
    const PoseNumbers numbers = parse_pose_numbers(line, file);
    if (pose_problem(line, numbers).empty()) {
      trajectory.poses.push_back(to_stamped_pose(line, numbers, file));
    } else {
      ++trajectory.left_out.invalid;
    }
  }
  const StampRepair repair = repair_stamp_order(trajectory.poses);
  trajectory.left_out.repeated = repair.repeated;
  trajectory.sorted = repair.sorted;
  const std::string name = file.filename().string();
  add_repair_notes(repair, name, lines.size(), trajectory.notes);
  if (trajectory.left_out.invalid > 0) {
    trajectory.notes.push_back(
        fmt::format("{}: {} of {} lines have no valid pose (values that are not finite, or a "
                    "quaternion of length zero); they are left out",
                    name, trajectory.left_out.invalid, lines.size()));
  }
  return trajectory;
}

std::vector<StampedPose> read_tum_in_any_order(const std::filesystem::path& file,
                                               std::vector<std::string>& notes) {
  ForeignTrajectory trajectory = read_foreign_tum(file);
  notes.insert(notes.end(), trajectory.notes.begin(), trajectory.notes.end());
  return std::move(trajectory.poses);
}

void write_tum(const std::filesystem::path& file, const Trajectory& trajectory) {
  std::string text = "# stamp tx ty tz qx qy qz qw (T_world_camera)\n";
  auto lost = trajectory.lost.begin();
  const auto write_lost_before = [&](const Timestamp* stamp) {
    for (; lost != trajectory.lost.end() && (stamp == nullptr || lost->stamp < *stamp); ++lost) {
      text += fmt::format("# lost {} {}\n", lost->stamp.to_string(), lost->reason);
    }
  };
  for (const auto& pose : trajectory.poses) {
    write_lost_before(&pose.stamp);
    text += format_line(pose);
  }
  write_lost_before(nullptr);
  write_file(file, text);
}

}  // namespace cvo_slam
