// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/synthetic/sensor_options.h"
#include "cvo_slam/synthetic/world_scene.h"

namespace cvo_slam::synthetic {

/// The pose of the camera, T_world_camera, at a time [s].
using CameraMotion = std::function<SE3(double seconds)>;

/// The times at which the two images of a frame are taken; empty = not taken.
struct Exposure {
  std::optional<double> color;  ///< [s]
  std::optional<double> depth;  ///< [s]
};

/// The images of a frame; an image that was not taken is empty.
struct Capture {
  cv::Mat color;  ///< CV_8UC3 (blue, green, red)
  cv::Mat depth;  ///< CV_16UC1 in the camera's depth units, 0 = no depth
};

/// A model of a real RGB-D camera that moves through a scene in which shapes may move. Frames can
/// be taken in any order and from several threads: their noise depends only on the seeds of world
/// and sensor and on the number of the frame.
class Sensor {
 public:
  /// Moving boxes are placed along the path of the camera in [0, duration] s. Throws OptionError
  /// for a bad option, for a camera with distortion, and if there is no space for the boxes.
  Sensor(WorldScene scene, CameraMotion T_world_camera, double duration, const Camera& camera,
         const SensorOptions& options, std::uint32_t world_seed);

  /// Returns the scene with the moving boxes.
  [[nodiscard]] const WorldScene& scene() const { return scene_; }
  /// Returns the images of a frame.
  [[nodiscard]] Capture capture(std::size_t frame, const Exposure& exposure) const;
  /// Returns the number of instants that an image taken at that time averages; 1 if nothing moves.
  [[nodiscard]] int instants(double seconds) const;

 private:
  [[nodiscard]] double image_motion(double seconds) const;
  [[nodiscard]] cv::Mat light(double seconds, int instants) const;

  WorldScene scene_;
  CameraMotion T_world_camera_;
  Camera camera_;
  SensorOptions options_;
  std::uint32_t seed_;
};

}  // namespace cvo_slam::synthetic
