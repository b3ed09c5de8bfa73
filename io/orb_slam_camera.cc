// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/camera_yaml_internal.h"
#include "cvo_slam/io/yaml_internal.h"

namespace cvo_slam {
namespace {

/// The value under the first of `keys` that the file has. ORB-SLAM3 took the prefix "Camera1." for
/// the intrinsics and left "Camera.width" as it was.
YAML::Node find(const YAML::Node& root, const std::vector<std::string>& keys) {
  for (const auto& key : keys) {
    if (const YAML::Node node = root[key]) return node;
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

class OrbSlamFile {
 public:
  OrbSlamFile(const YAML::Node& root, const std::filesystem::path& file)
      : root_(root), file_(file) {}

  [[nodiscard]] double number(const std::vector<std::string>& keys) const {
    return parse_yaml_number(require(keys), keys.front(), file_);
  }
  [[nodiscard]] double number_or(const std::vector<std::string>& keys, double otherwise) const {
    const YAML::Node node = find(root_, keys);
    return node ? parse_yaml_number(node, keys.front(), file_) : otherwise;
  }
  [[nodiscard]] int size(const std::vector<std::string>& keys) const {
    return parse_yaml_size(require(keys), keys.front(), file_);
  }

 private:
  [[nodiscard]] YAML::Node require(const std::vector<std::string>& keys) const {
    YAML::Node node = find(root_, keys);
    if (!node) throw InputError(file_, fmt::format("the key '{}' is missing", keys.front()));
    return node;
  }

  const YAML::Node& root_;
  const std::filesystem::path& file_;
};

void check_model(const YAML::Node& root, const std::filesystem::path& file) {
  const YAML::Node type = root["Camera.type"];
  if (!type || type.Scalar() == "PinHole") return;
  throw InputError(file, line_of(type),
                   fmt::format("Camera.type: only PinHole is supported, not '{}'", type.Scalar()));
}

}  // namespace

bool has_orb_slam_keys(const YAML::Node& root) { return root["Camera.fx"] || root["Camera1.fx"]; }

Camera parse_orb_slam_camera(const YAML::Node& root, const std::filesystem::path& path) {
  check_model(root, path);
  const OrbSlamFile file(root, path);
  Camera camera;
  camera.name = path.stem().string();
  camera.color.width = file.size({"Camera.width"});
  camera.color.height = file.size({"Camera.height"});
  camera.color.fx = file.number({"Camera.fx", "Camera1.fx"});
  camera.color.fy = file.number({"Camera.fy", "Camera1.fy"});
  camera.color.cx = file.number({"Camera.cx", "Camera1.cx"});
  camera.color.cy = file.number({"Camera.cy", "Camera1.cy"});
  std::size_t i = 0;
  for (const char* name : {"k1", "k2", "p1", "p2", "k3"}) {
    camera.color.distortion[i++] =
        file.number_or({fmt::format("Camera.{}", name), fmt::format("Camera1.{}", name)}, 0);
  }
  camera.depth_scale = file.number({"DepthMapFactor", "RGBD.DepthMapFactor"});
  return camera;
}

}  // namespace cvo_slam
