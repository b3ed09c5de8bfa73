// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/trajectory_files.h"

#include <array>
#include <string>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

StampedPose parse_pose(const TextLine& line, const std::filesystem::path& file) {
  const auto fail = [&](const std::string& problem) {
    throw InputError(file, line.number, problem);
  };
  constexpr std::size_t kValues = 8;
  if (line.words.size() != kValues) {
    fail(
        fmt::format("expected 8 values 'stamp tx ty tz qx qy qz qw', found {}", line.words.size()));
  }
  const Timestamp stamp = parse_stamp(line, 0, file);
  std::array<double, 7> value{};
  for (std::size_t i = 0; i < value.size(); ++i) {
    const auto parsed = parse_finite(line.words[i + 1]);
    if (!parsed) {
      fail(
          fmt::format("'{}' is not a finite number; repair or remove the line", line.words[i + 1]));
    }
    value[i] = *parsed;
  }
  const auto& [tx, ty, tz, qx, qy, qz, qw] = value;
  if (qx * qx + qy * qy + qz * qz + qw * qw < 1e-12) {
    fail("the quaternion has length zero; repair or remove the line");
  }
  return {stamp, SE3::from_quaternion(qx, qy, qz, qw, {tx, ty, tz})};
}

std::string format_pose(const StampedPose& pose) {
  const Vector3& t = pose.T_world_camera.translation();
  const Eigen::Vector4d q = pose.T_world_camera.quaternion();
  return fmt::format("{} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f}\n",
                     pose.stamp.to_string(), t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
}

}  // namespace

std::vector<StampedPose> read_tum(const std::filesystem::path& file) {
  std::vector<StampedPose> poses;
  for (const auto& line : read_word_lines(file)) {
    const StampedPose pose = parse_pose(line, file);
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

std::vector<StampedPose> read_tum_in_any_order(const std::filesystem::path& file,
                                               std::vector<std::string>& notes) {
  std::vector<StampedPose> poses;
  for (const auto& line : read_word_lines(file)) {
    poses.push_back(parse_pose(line, file));
  }
  repair_stamp_order(poses, file.filename().string(), notes);
  return poses;
}

void write_tum(const std::filesystem::path& file, const Trajectory& trajectory) {
  std::string text = "# stamp tx ty tz qx qy qz qw (T_world_camera)\n";
  auto lost = trajectory.lost.begin();
  const auto write_lost_before = [&](const Timestamp* stamp) {
    for (; lost != trajectory.lost.end() && (!stamp || lost->stamp < *stamp); ++lost) {
      text += fmt::format("# lost {} {}\n", lost->stamp.to_string(), lost->reason);
    }
  };
  for (const auto& pose : trajectory.poses) {
    write_lost_before(&pose.stamp);
    text += format_pose(pose);
  }
  write_lost_before(nullptr);
  write_file(file, text);
}

}  // namespace cvo_slam
