// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/moving_objects_internal.h"
#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/ray_caster_internal.h"

namespace cvo_slam::synthetic {
namespace {

using CameraMotion = std::function<SE3(double)>;

std::vector<Vector3> camera_positions(const CameraMotion& T_world_camera, double duration) {
  constexpr double kStep = 0.05;  // [s]; a hand moves by a few centimetres
  std::vector<Vector3> positions(static_cast<std::size_t>(duration / kStep) + 1);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positions[i] = T_world_camera(static_cast<double>(i) * kStep).translation();
  }
  return positions;
}

double distance_to_segment(const Vector3& point, const Vector3& middle, const Vector3& half) {
  const double squared = half.squaredNorm();
  const double share = squared > 0 ? (point - middle).dot(half) / squared : 0;
  return (point - middle - std::clamp(share, -1.0, 1.0) * half).norm();
}

/// Returns a position for a box in front of the camera at `pose`, nearer than the surface behind
/// it.
Vector3 place_in_view(const WorldScene& scene, const SE3& pose, Random& random) {
  constexpr double kFarthest = 2.5;  // [m]; a box farther away would hide little
  const PinholeCamera pixel{.width = 1, .height = 1, .fx = 1, .fy = 1, .cx = 0, .cy = 0};
  const double depth = RayCaster(scene, pixel, pose).look(0, 0).depth;
  const double free = depth > 0 ? std::min(depth, kFarthest) : kFarthest;
  return pose * Vector3(0, 0, free * random.uniform(0.5, 0.8));
}

Texture colorful(Random& random) {
  Texture texture;
  texture.pattern = random.bits() % 2 == 0 ? Pattern::kPlaid : Pattern::kPoster;
  for (int i = 0; i < 3; ++i) {
    texture.base[i] = random.uniform(0.2, 0.9);
    texture.accent[i] = random.uniform(0.1, 0.9);
  }
  texture.seed = random.bits();
  return texture;
}

/// Returns a random box, smaller with a smaller `scale`.
Primitive swinging_box(const Vector3& position, const SE3& camera,
                       const MovingObjectOptions& options, double scale, Random& random) {
  const auto edge = [&] { return scale * options.size * random.uniform(0.7, 1.3); };
  const double width = edge();
  const double depth = edge();
  const double height = edge();
  const double yaw = random.uniform(0, 2 * std::numbers::pi);
  Primitive box{Box{{width, depth, height}}, SE3(so3_exp({0, 0, yaw}), position), colorful(random)};
  // It moves across the field of view, and a little up and down.
  const double reach = scale * random.uniform(0.4, 0.8);  // [m]
  const Vector3 across = camera.rotation() * Vector3(1, random.uniform(-0.3, 0.3), 0).normalized();
  if (options.speed > 0) {
    box.swing =
        Swing{reach * across, 2 * std::numbers::pi * reach / options.speed, random.uniform(0, 1)};
  }
  return box;
}

bool is_clear(const Primitive& primitive, const std::vector<Vector3>& positions) {
  constexpr double kClearance = 0.3;  // [m]
  const double radius = 0.5 * std::get<Box>(primitive.shape).size.norm();
  const Vector3 amplitude = primitive.swing ? primitive.swing->amplitude : Vector3::Zero();
  return std::all_of(positions.begin(), positions.end(), [&](const Vector3& position) {
    return distance_to_segment(position, primitive.T_world_shape.translation(), amplitude) >
           radius + kClearance;
  });
}

}  // namespace

void add_moving_objects(WorldScene& scene, const CameraMotion& T_world_camera, double duration,
                        const MovingObjectOptions& options, std::uint32_t seed) {
  if (options.count == 0) return;
  constexpr int kAttempts = 100;
  constexpr double kShrink = 0.97;  // 0.97^100: a twentieth of the size after all attempts
  const std::vector<Vector3> positions = camera_positions(T_world_camera, duration);
  const WorldScene still = scene;
  for (int i = 0; i < options.count; ++i) {
    Random random(derived_seed(seed, i));
    double scale = 1;
    for (int attempt = 0; attempt < kAttempts; ++attempt, scale *= kShrink) {
      const SE3 camera = T_world_camera(random.uniform(0, duration));
      const Vector3 position = place_in_view(still, camera, random);
      const Primitive box = swinging_box(position, camera, options, scale, random);
      if (!is_clear(box, positions)) continue;
      scene.primitives.push_back(box);
      break;
    }
    if (scene.primitives.size() != still.primitives.size() + static_cast<std::size_t>(i) + 1) {
      throw OptionError(
          "sensor.objects: there is no space for a moving box clear of the camera path; lower "
          "objects.size or objects.count");
    }
  }
}

}  // namespace cvo_slam::synthetic
