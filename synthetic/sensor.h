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
#include "cvo_slam/synthetic/scene.h"
#include "cvo_slam/synthetic/sensor_options.h"

namespace cvo_slam::synthetic {

/// Where the camera is at a time [s].
using CameraMotion = std::function<SE3(double seconds)>;

/// When the two images of a frame are taken; empty = not at all.
struct Exposure {
  std::optional<double> color;  ///< [s]
  std::optional<double> depth;  ///< [s]
};

/// The images of a frame; one that was not taken is empty.
struct Capture {
  cv::Mat color;  ///< CV_8UC3 (blue, green, red)
  cv::Mat depth;  ///< CV_16UC1 in the camera's depth units, 0 = no depth
};

/// An RGB-D camera with its flaws, moved through a scene in which things may move. Any frame can be
/// taken on its own, in any order and from several threads: what is random about it follows from
/// the seeds of world and sensor and its number.
class Sensor {
 public:
  /// Boxes that swing through the view are placed along the camera's way in [0, duration] s.
  /// Throws OptionError for a bad option, a camera with distortion, or boxes without a place.
  Sensor(Scene scene, CameraMotion T_world_camera, double duration, const Camera& camera,
         const SensorOptions& options, std::uint32_t world_seed);

  /// The scene with what the options add to it.
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] Capture capture(std::size_t frame, const Exposure& exposure) const;
  /// Over how many instants an image taken at that time averages: one where nothing moves.
  [[nodiscard]] int instants(double seconds) const;

 private:
  [[nodiscard]] double image_motion(double seconds) const;
  [[nodiscard]] cv::Mat light(double seconds, int instants) const;

  Scene scene_;
  CameraMotion T_world_camera_;
  Camera camera_;
  SensorOptions options_;
  std::uint32_t seed_;
};

}  // namespace cvo_slam::synthetic
