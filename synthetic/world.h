// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cvo_slam/synthetic/camera_path.h"
#include "cvo_slam/synthetic/scene.h"

namespace cvo_slam::synthetic {

/// Where all but a world's own path are walked.
struct Anchor {
  Viewpoint view;
  /// How far the camera may turn away from the target to either side; pi = all around [rad].
  double pan = std::numbers::pi;
};

/// A scene and a camera's way through it.
struct World {
  Scene scene;
  CameraPath path;
  Anchor anchor;
};

/// How a camera moves; all are made from a world's anchor.
enum class PathStyle {
  kHandheld,  ///< wanders about the anchor and looks around, as a hand does
  kOrbit,     ///< on an arc about the anchor's target, to and fro
  kWalk,      ///< along the world's own path, with the view ahead
  kRotate,    ///< turns on the spot: no translation at all
  kStill,     ///< on a tripod: no motion at all
  kShake,     ///< stands, and trembles five (turning: ten) times as much as a hand
};
[[nodiscard]] const std::vector<std::pair<std::string, PathStyle>>& path_style_names();

struct WorldOptions {
  std::uint32_t seed = 1;                         ///< of textures, clutter and tremor
  std::optional<PathStyle> style = std::nullopt;  ///< empty = the world's own path
  double speed = 1;                               ///< 2 = the same way in half the time
};

/// The built-in world of that name, or that of a file, which a name ending in ".yaml" or ".yml"
/// means. The seed changes textures, clutter and tremor, not the plan.
/// Throws OptionError for an unknown name (the message gives the nearest one), for a speed that is
/// not positive, and where the path of that style would lead the camera into a surface; InputError
/// for a bad file.
[[nodiscard]] World make_world(const std::string& name, const WorldOptions& options = {});
[[nodiscard]] std::vector<std::string> world_names();

/// Throws OptionError where the camera comes nearer than 5 cm to a surface; the message names the
/// time. What moves is taken where it rests.
void check_path(const Scene& scene, const CameraPath& path);

}  // namespace cvo_slam::synthetic
