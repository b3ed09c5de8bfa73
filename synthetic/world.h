// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cvo_slam/synthetic/camera_path.h"
#include "cvo_slam/synthetic/world_scene.h"

namespace cvo_slam::synthetic {

/// The viewpoint that all path styles but kWalk are built around.
struct Anchor {
  Viewpoint view;  ///< where the camera stands, and what it looks at
  /// Largest turn of the camera away from the target to either side; pi = all around [rad].
  double pan = std::numbers::pi;
};

/// A scene and the path of a camera through it.
struct World {
  WorldScene scene;  ///< what there is to see
  CameraPath path;   ///< how the camera moves
  Anchor anchor;     ///< what paths of most styles are built around
};

/// Styles of camera motion. All paths are made from the anchor of a world, except kWalk.
enum class PathStyle {
  kHandheld,  ///< moves about the anchor and looks around, as a hand-held camera does
  kOrbit,     ///< moves to and fro on an arc about the target of the anchor
  kWalk,      ///< follows the world's own path and looks ahead
  kRotate,    ///< turns on the spot, without any translation
  kStill,     ///< does not move at all
  kShake,     ///< stands and trembles: five times the translation, ten times the rotation of a hand
};

/// Returns the names that users type: handheld, orbit, ...
[[nodiscard]] const std::vector<std::pair<std::string, PathStyle>>& path_style_names();

/// What make_world() varies.
struct WorldOptions {
  std::uint32_t seed = 1;  ///< seed of textures, clutter and tremor
  /// Seed of another walk through the same world: another tremor, on a path whose viewpoints are
  /// moved by up to a decimetre. Empty: the tremor of `seed` on the path as it is.
  std::optional<std::uint32_t> path_seed = std::nullopt;
  std::optional<PathStyle> style = std::nullopt;  ///< empty = the world's own path
  double speed = 1;                               ///< 2 = the same path in half the time
};

/// Returns the built-in world of that name or, if the name ends in ".yaml" or ".yml", the world of
/// that file. The seed changes textures, clutter and tremor, but not the layout. Throws OptionError
/// for an unknown name (the message suggests the nearest one), for a speed that is not positive,
/// and if the path would lead the camera into a surface. Throws InputError for a bad file.
[[nodiscard]] World make_world(const std::string& name, const WorldOptions& options = {});
/// Returns the names of the built-in worlds.
[[nodiscard]] std::vector<std::string> world_names();

/// Reads a world file; docs/reference/synthetic-worlds.md describes the format. Textures and tremor
/// without a seed of their own get one from `seed`. Throws InputError with file and line for an
/// unknown key or word (the message suggests the nearest one), a bad number, an impossible size,
/// too few viewpoints, and if the camera would come nearer than 5 cm to a surface (with the time).
[[nodiscard]] World read_world(const std::filesystem::path& file, std::uint32_t seed = 1);
/// Reads a world from a text. `file` is named in error messages.
[[nodiscard]] World parse_world(const std::string& text, const std::filesystem::path& file,
                                std::uint32_t seed = 1);

/// Returns the text of a world file that gives exactly this world again, to the last bit.
[[nodiscard]] std::string world_text(const World& world);

/// Throws OptionError, which names the time, if the camera comes nearer than 5 cm to a surface.
/// Moving shapes are taken at rest.
void check_path(const WorldScene& scene, const CameraPath& path);

}  // namespace cvo_slam::synthetic
