// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/camera_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/builtin_camera_files_internal.h"
#include "cvo_slam/io/text_internal.h"
#include "cvo_slam/io/yaml_value.h"

namespace cvo_slam {
namespace {

std::vector<std::string> with_pinhole_keys(std::vector<std::string> keys) {
  for (const char* key : {"width", "height", "fx", "fy", "cx", "cy", "distortion"}) {
    keys.emplace_back(key);
  }
  return keys;
}

int pixels(const YamlValue& value, const std::string& what) {
  constexpr double kLargest = 65536;
  const double number = value.number(what);
  if (number < 1 || number > kLargest || number != std::floor(number)) {
    value.fail(fmt::format("{}: expected a number of pixels", what));
  }
  return static_cast<int>(number);
}

PinholeCamera parse_pinhole(const YamlValue& map, const std::string& what) {
  const auto number = [&](const std::string& key) { return map.require(key, what).number(key); };
  PinholeCamera camera;
  camera.width = pixels(map.require("width", what), "width");
  camera.height = pixels(map.require("height", what), "height");
  camera.fx = number("fx");
  camera.fy = number("fy");
  camera.cx = number("cx");
  camera.cy = number("cy");
  if (const YamlValue* distortion = map.find("distortion")) {
    const auto values = distortion->numbers("distortion", camera.distortion.size());
    std::copy(values.begin(), values.end(), camera.distortion.begin());
  }
  return camera;
}

SE3 parse_pose(const YamlValue& value, const std::string& what) {
  const std::string expected = fmt::format("{}: expected a rigid 4x4 matrix, four rows", what);
  const std::vector<YamlValue>& rows = value.list(what);
  if (rows.size() != 4) value.fail(expected);
  Eigen::Matrix4d matrix;
  for (Eigen::Index row = 0; row < 4; ++row) {
    const auto values = rows[static_cast<std::size_t>(row)].numbers(what, 4);
    matrix.row(row) = Eigen::RowVector4d::Map(values.data());
  }
  // Calibrations typed by hand have 4 digits or more; what is further off is not a rotation.
  constexpr double kTolerance = 1e-3;
  const Matrix3 rotation = matrix.topLeftCorner<3, 3>();
  // One that we wrote stays as it is, so that it is the same when it is written again.
  constexpr double kRounding = 1e-14;
  const bool is_exact =
      (rotation * rotation.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff() < kRounding &&
      rotation.determinant() > 0;
  SE3 pose = is_exact ? SE3(rotation, matrix.topRightCorner<3, 1>()) : SE3::from_matrix(matrix);
  if ((rotation - pose.rotation()).norm() > kTolerance ||
      matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    value.fail(expected);
  }
  return pose;
}

SensorNoise parse_noise(const YamlValue& map) {
  map.check_keys({"depth_floor", "depth_quadratic", "pixel"}, "noise");
  const auto deviation_or = [&](const std::string& key, double otherwise) {
    const YamlValue* value = map.find(key);
    if (value == nullptr) return otherwise;
    const double deviation = value->number(key);
    if (deviation < 0) value->fail(fmt::format("{}: {} must not be negative", key, deviation));
    return deviation;
  };
  const SensorNoise standard;
  return {deviation_or("depth_floor", standard.depth_floor),
          deviation_or("depth_quadratic", standard.depth_quadratic),
          deviation_or("pixel", standard.pixel)};
}

DepthCamera parse_depth_camera(const YamlValue& map) {
  map.check_keys(with_pinhole_keys({"T_color_depth"}), "depth");
  return {parse_pinhole(map, "depth"),
          parse_pose(map.require("T_color_depth", "depth"), "T_color_depth")};
}

Camera parse_own_camera(const YamlValue& root, const std::string& file_name) {
  root.check_keys(
      with_pinhole_keys({"name", "depth_scale", "readout_time", "depth_offset", "noise", "depth"}),
      "camera");
  Camera camera;
  camera.name = root.find("name") != nullptr ? root.find("name")->word("name") : file_name;
  camera.color = parse_pinhole(root, "camera");
  camera.depth_scale = root.require("depth_scale", "camera").number("depth_scale");
  if (const YamlValue* time = root.find("readout_time")) {
    camera.readout_time = time->number("readout_time");
  }
  if (const YamlValue* offset = root.find("depth_offset")) {
    camera.depth_offset = offset->number("depth_offset");
  }
  if (const YamlValue* noise = root.find("noise")) camera.noise = parse_noise(*noise);
  if (const YamlValue* depth = root.find("depth")) camera.depth = parse_depth_camera(*depth);
  return camera;
}

/// Returns the value of the one of `keys` that the file has, or a null pointer: ORB-SLAM3 renamed
/// the intrinsics to "Camera1.fx" and left "Camera.width" as it was; OpenVSLAM calls that
/// "Camera.cols".
const YamlValue* find_one(const YamlValue& root, const std::vector<std::string>& keys) {
  const YamlValue* found = nullptr;
  for (const auto& key : keys) {
    const YamlValue* value = root.find(key);
    if (value == nullptr) continue;
    if (found != nullptr) {
      value->fail_at_key(
          fmt::format("'{}' is one of {}, and the file has another; remove one of them", key,
                      fmt::join(keys, ", ")));
    }
    found = value;
  }
  return found;
}

/// Returns the part of a key that names a property of the camera: "fx" for "Camera.fx" and
/// "Camera1.fx"; empty for keys of other parts of the program.
std::string_view camera_property(std::string_view key) {
  for (const std::string_view prefix : {"Camera.", "Camera1."}) {
    if (key.starts_with(prefix)) return key.substr(prefix.size());
  }
  return {};
}

bool is_settings_file(const YamlValue& root) {
  const auto& entries = root.map("camera");
  return std::any_of(entries.begin(), entries.end(),
                     [](const auto& entry) { return !camera_property(entry.first).empty(); });
}

template <std::size_t kCount>
bool contains(const std::array<std::string_view, kCount>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Refuses a model that is not a pinhole camera, and a sensor that is not an RGB-D camera.
void check_kind(std::string_view name, const std::string& key, const YamlValue& value) {
  const std::string& word = value.word(key);
  const std::string kind = to_lower(word);
  if (name == "setup") {
    if (kind == "rgbd") return;
    value.fail(
        fmt::format("{}: only RGBD is supported, not {}; give the settings of an RGB-D camera", key,
                    in_quotes(word)));
  }
  if (kind == "pinhole" || kind == "perspective") return;
  value.fail(
      fmt::format("{}: only PinHole (perspective) is supported, not {}; undistort the "
                  "images to a pinhole camera first",
                  key, in_quotes(word)));
}

/// Refuses images that other programs make smaller after reading them.
void check_same_size(const YamlValue& root, std::string_view name, const std::string& key,
                     const YamlValue& value) {
  const YamlValue* same = nullptr;
  if (name == "newWidth") same = find_one(root, {"Camera.width", "Camera.cols"});
  if (name == "newHeight") same = find_one(root, {"Camera.height", "Camera.rows"});
  if (value.number(key) == (same != nullptr ? same->number(key) : 1)) return;
  value.fail_at_key(fmt::format(
      "{}: images are not resized; remove the key and give the intrinsics of the images as they "
      "are stored",
      key));
}

/// Refuses what would make the lens or the images others than those that are read.
void check_property(const YamlValue& root, const std::string& key, const YamlValue& value) {
  constexpr std::array<std::string_view, 13> kRead = {
      "width", "height", "cols", "rows", "fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3"};
  // None of these changes where a pixel looks.
  constexpr std::array<std::string_view, 8> kHarmless = {
      "name", "fps", "RGB", "color_order", "bf", "ThDepth", "focal_x_baseline", "depth_threshold"};
  constexpr std::array<std::string_view, 4> kOtherLens = {"k4", "k5", "k6", "bFishEye"};
  constexpr std::array<std::string_view, 3> kKinds = {"model", "type", "setup"};
  constexpr std::array<std::string_view, 3> kSizes = {"imageScale", "newWidth", "newHeight"};
  const std::string_view name = camera_property(key);
  if (contains(kRead, name) || contains(kHarmless, name)) return;
  if (contains(kKinds, name)) return check_kind(name, key, value);
  if (contains(kSizes, name)) return check_same_size(root, name, key, value);
  if (!contains(kOtherLens, name)) {
    value.fail_at_key(fmt::format(
        "unknown key {}; remove it if it does not change the lens or the images", in_quotes(key)));
  }
  if (value.number(key) == 0) return;
  value.fail_at_key(fmt::format(
      "{}: {} is a lens that is not supported, only k1, k2, p1, p2 and k3 are; undistort the "
      "images, or calibrate them with these five",
      key, value.word(key)));
}

void check_settings(const YamlValue& root) {
  // The model first: it says more than the coefficients that come with it.
  for (const char* key : {"Camera.type", "Camera.model", "Camera1.type", "Camera1.model"}) {
    if (const YamlValue* value = root.find(key)) check_property(root, key, *value);
  }
  for (const auto& [key, value] : root.map("camera")) {
    if (!camera_property(key).empty()) check_property(root, key, value);
    for (const char* prefix : {"Camera2.", "LEFT.", "RIGHT.", "Stereo.T_"}) {
      if (!key.starts_with(prefix)) continue;
      value.fail_at_key(fmt::format(
          "{} is of a stereo camera; give the settings of an RGB-D camera", in_quotes(key)));
    }
  }
}

Camera parse_settings_camera(const YamlValue& root, const std::string& file_name) {
  check_settings(root);
  const auto find_or_fail = [&](const std::vector<std::string>& keys) -> const YamlValue& {
    const YamlValue* value = find_one(root, keys);
    return value != nullptr ? *value : root.require(keys.front(), "camera");
  };
  const auto number = [&](const std::vector<std::string>& keys) {
    return find_or_fail(keys).number(keys.front());
  };
  Camera camera;
  camera.name = file_name;
  camera.color.width = pixels(find_or_fail({"Camera.width", "Camera.cols"}), "Camera.width");
  camera.color.height = pixels(find_or_fail({"Camera.height", "Camera.rows"}), "Camera.height");
  camera.color.fx = number({"Camera.fx", "Camera1.fx"});
  camera.color.fy = number({"Camera.fy", "Camera1.fy"});
  camera.color.cx = number({"Camera.cx", "Camera1.cx"});
  camera.color.cy = number({"Camera.cy", "Camera1.cy"});
  std::size_t i = 0;
  for (const char* name : {"k1", "k2", "p1", "p2", "k3"}) {
    const std::string key = fmt::format("Camera.{}", name);
    const YamlValue* value = find_one(root, {key, fmt::format("Camera1.{}", name)});
    camera.color.distortion[i++] = value != nullptr ? value->number(key) : 0;
  }
  camera.depth_scale = number({"DepthMapFactor", "RGBD.DepthMapFactor", "depthmap_factor"});
  return camera;
}

/// `file` gives the camera its name unless the text does.
Camera parse_camera(const std::string& text, const std::filesystem::path& file) {
  const YamlValue root = YamlValue::parse(text, file);
  if (root.is_empty()) {
    throw InputError(file, "is empty; a camera needs width, height, fx, fy, ...");
  }
  const std::string file_name = file.stem().string();
  Camera camera = is_settings_file(root) ? parse_settings_camera(root, file_name)
                                         : parse_own_camera(root, file_name);
  try {
    camera.check();
  } catch (const OptionError& error) {
    throw InputError(file, error.what());
  }
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

std::string depth_camera_to_yaml(const DepthCamera& camera) {
  std::string text = "depth:\n" + pinhole_to_yaml(camera.pinhole, "  ") + "  T_color_depth:\n";
  const Eigen::Matrix4d matrix = camera.T_color_depth.matrix();
  for (int row = 0; row < 4; ++row) {
    text += fmt::format("    - [{}, {}, {}, {}]\n", matrix(row, 0), matrix(row, 1), matrix(row, 2),
                        matrix(row, 3));
  }
  return text;
}

std::string camera_to_yaml(const Camera& camera) {
  std::string text = fmt::format("name: {}\n", to_yaml_word(camera.name));
  text += pinhole_to_yaml(camera.color, "");
  text +=
      fmt::format("depth_scale: {}  # units of the depth image per metre\n", camera.depth_scale);
  if (camera.readout_time != 0) {
    text += fmt::format("readout_time: {}  # rolling shutter, first to last row [s]\n",
                        camera.readout_time);
  }
  if (camera.depth_offset) {
    text += fmt::format("depth_offset: {}  # to be added to the stamps of depth images [s]\n",
                        *camera.depth_offset);
  }
  text += fmt::format(
      "noise:  # standard deviations: of depth z, max(depth_floor, depth_quadratic z^2)\n"
      "  depth_floor: {}  # [m]\n  depth_quadratic: {}  # [1/m]\n  pixel: {}  # [px]\n",
      camera.noise.depth_floor, camera.noise.depth_quadratic, camera.noise.pixel);
  if (camera.depth) text += depth_camera_to_yaml(*camera.depth);
  return text;
}

}  // namespace

Camera read_camera(const std::filesystem::path& file) {
  return parse_camera(read_file(file), file);
}

void write_camera(const std::filesystem::path& file, const Camera& camera) {
  write_file(file, camera_to_yaml(camera));
}

Camera builtin_camera(const std::string& name) {
  for (const auto& file : builtin_camera_files()) {
    if (file.name == name) return parse_camera(std::string(file.text), name + ".yaml");
  }
  throw OptionError(fmt::format("no built-in camera '{}'; there are {}", name,
                                fmt::join(builtin_camera_names(), ", ")));
}

std::vector<std::string> builtin_camera_names() {
  std::vector<std::string> names;
  for (const auto& file : builtin_camera_files()) names.emplace_back(file.name);
  return names;
}

Camera find_camera(const std::string& name_or_file) {
  const auto names = builtin_camera_names();
  if (std::find(names.begin(), names.end(), name_or_file) != names.end()) {
    return builtin_camera(name_or_file);
  }
  if (!std::filesystem::exists(name_or_file)) {
    throw InputError(name_or_file, fmt::format("no such camera file; the built-in cameras are {}",
                                               fmt::join(names, ", ")));
  }
  return read_camera(name_or_file);
}

}  // namespace cvo_slam
