// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/io/camera_yaml_internal.h"
#include "cvo_slam/io/text_internal.h"
#include "cvo_slam/io/yaml_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

const std::vector<std::string> kPinholeKeys = {"width", "height", "fx",        "fy",
                                               "cx",    "cy",     "distortion"};

std::vector<std::string> with_pinhole_keys(std::vector<std::string> keys) {
  keys.insert(keys.end(), kPinholeKeys.begin(), kPinholeKeys.end());
  return keys;
}

void check_known(const YAML::Node& map, const std::vector<std::string>& known, const Path& file) {
  for (const auto& entry : map) {
    const std::string& key = entry.first.Scalar();
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw InputError(file, line_of(entry.first),
                     fmt::format("unknown key '{}'; {}", key, suggestion(key, known)));
  }
}

YAML::Node require(const YAML::Node& map, const std::string& key, const Path& file) {
  const YAML::Node node = map[key];
  if (!node) throw InputError(file, line_of(map), fmt::format("the key '{}' is missing", key));
  return node;
}

/// A list of exactly `count` numbers.
std::vector<double> parse_numbers(const YAML::Node& node, std::size_t count, const std::string& key,
                                  const Path& file) {
  if (!node.IsSequence() || node.size() != count) {
    throw InputError(file, line_of(node), fmt::format("{}: expected {} numbers", key, count));
  }
  std::vector<double> values;
  for (const auto& item : node) values.push_back(parse_yaml_number(item, key, file));
  return values;
}

PinholeCamera parse_pinhole(const YAML::Node& map, const Path& file) {
  const auto number = [&](const std::string& key) {
    return parse_yaml_number(require(map, key, file), key, file);
  };
  PinholeCamera camera;
  camera.width = parse_yaml_size(require(map, "width", file), "width", file);
  camera.height = parse_yaml_size(require(map, "height", file), "height", file);
  camera.fx = number("fx");
  camera.fy = number("fy");
  camera.cx = number("cx");
  camera.cy = number("cy");
  if (const YAML::Node node = map["distortion"]) {
    const auto values = parse_numbers(node, camera.distortion.size(), "distortion", file);
    std::copy(values.begin(), values.end(), camera.distortion.begin());
  }
  return camera;
}

SE3 parse_pose(const YAML::Node& node, const std::string& key, const Path& file) {
  const std::string expected = fmt::format("{}: expected a rigid 4x4 matrix, four rows", key);
  if (!node.IsSequence() || node.size() != 4) throw InputError(file, line_of(node), expected);
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row) {
    const auto values = parse_numbers(node[row], 4, key, file);
    matrix.row(row) = Eigen::RowVector4d::Map(values.data());
  }
  // Hand-typed calibrations have 4 digits or more; anything further off is not a rotation.
  constexpr double kTolerance = 1e-3;
  const Matrix3 rotation = matrix.topLeftCorner<3, 3>();
  const SE3 pose = SE3::from_matrix(matrix);
  if ((rotation - pose.rotation()).norm() > kTolerance ||
      matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    throw InputError(file, line_of(node), expected);
  }
  return pose;
}

DepthCamera parse_depth_camera(const YAML::Node& map, const Path& file) {
  if (!map.IsMap()) throw InputError(file, line_of(map), "depth: expected a map of keys");
  check_known(map, with_pinhole_keys({"T_color_depth"}), file);
  return {parse_pinhole(map, file),
          parse_pose(require(map, "T_color_depth", file), "T_color_depth", file)};
}

Camera parse_own_camera(const YAML::Node& root, const Path& file) {
  check_known(root, with_pinhole_keys({"name", "depth_scale", "readout_time", "depth"}), file);
  Camera camera;
  camera.name = root["name"] ? root["name"].Scalar() : file.stem().string();
  camera.color = parse_pinhole(root, file);
  camera.depth_scale = parse_yaml_number(require(root, "depth_scale", file), "depth_scale", file);
  if (const YAML::Node time = root["readout_time"]) {
    camera.readout_time = parse_yaml_number(time, "readout_time", file);
  }
  if (const YAML::Node depth = root["depth"]) camera.depth = parse_depth_camera(depth, file);
  return camera;
}

std::string pinhole_to_yaml(const PinholeCamera& camera, const std::string& indent) {
  std::string text =
      fmt::format("{0}width: {1}\n{0}height: {2}\n{0}fx: {3}\n{0}fy: {4}\n{0}cx: {5}\n{0}cy: {6}\n",
                  indent, camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy);
  if (camera.has_distortion()) {
    text += fmt::format("{}distortion: [{}]  # k1, k2, p1, p2, k3\n", indent,
                        fmt::join(camera.distortion, ", "));
  }
  return text;
}

}  // namespace

double parse_yaml_number(const YAML::Node& node, const std::string& key, const Path& file) {
  const auto value = node.IsScalar() ? parse_finite(node.Scalar()) : std::nullopt;
  if (!value) throw InputError(file, line_of(node), fmt::format("{}: expected a number", key));
  return *value;
}

int parse_yaml_size(const YAML::Node& node, const std::string& key, const Path& file) {
  constexpr double kLargest = 65536;
  const double value = parse_yaml_number(node, key, file);
  if (value < 1 || value > kLargest || value != std::floor(value)) {
    throw InputError(file, line_of(node), fmt::format("{}: expected a number of pixels", key));
  }
  return static_cast<int>(value);
}

Camera parse_camera(const std::string& text, const Path& file) {
  const YAML::Node root = parse_yaml(text, file);
  if (!root.IsMap()) throw InputError(file, "is empty; a camera needs width, height, fx, fy, ...");
  const Camera camera =
      has_orb_slam_keys(root) ? parse_orb_slam_camera(root, file) : parse_own_camera(root, file);
  try {
    camera.check();
  } catch (const OptionError& error) {
    throw InputError(file, error.what());
  }
  return camera;
}

std::string camera_to_yaml(const Camera& camera) {
  std::string text = fmt::format("name: {}\n", YAML::Dump(YAML::Node(camera.name)));
  text += pinhole_to_yaml(camera.color, "");
  text += fmt::format("depth_scale: {}  # units of the depth image a metre\n", camera.depth_scale);
  if (camera.readout_time != 0) {
    text += fmt::format("readout_time: {}  # of the rolling shutter [s]\n", camera.readout_time);
  }
  if (!camera.depth) return text;
  text += "depth:\n" + pinhole_to_yaml(camera.depth->pinhole, "  ") + "  T_color_depth:\n";
  const Eigen::Matrix4d matrix = camera.depth->T_color_depth.matrix();
  for (int row = 0; row < 4; ++row) {
    text += fmt::format("    - [{}, {}, {}, {}]\n", matrix(row, 0), matrix(row, 1), matrix(row, 2),
                        matrix(row, 3));
  }
  return text;
}

}  // namespace cvo_slam
