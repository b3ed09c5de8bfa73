// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/sensor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/core.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/image_sensors_internal.h"
#include "cvo_slam/synthetic/moving_objects_internal.h"
#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/rendering_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// The purposes of the seeds of a sensor.
enum Purpose : std::int32_t { kObjects, kGain, kImageNoise, kDepthNoise };

IdealImages images_at(const Motion& motion, double seconds, double readout,
                      const Channels& channels, std::optional<int> rim_ray = std::nullopt) {
  RowRays rays(motion, seconds, readout);
  return cast_image(
      motion.camera, [&rays](int y) -> const RayCaster& { return rays.of_row(y); }, channels,
      rim_ray);
}

/// Returns the position of a point of a primitive at another time of the scene.
Vector3 carried(const Vector3& point, const Primitive& from, const Primitive& to) {
  return to.T_world_shape * (from.T_world_shape.inverse() * point);
}

}  // namespace

Sensor::Sensor(WorldScene scene, CameraMotion T_world_camera, double duration, const Camera& camera,
               const SensorOptions& options, std::uint32_t world_seed)
    : scene_(std::move(scene)),
      T_world_camera_(std::move(T_world_camera)),
      camera_(camera),
      options_(options),
      seed_(sensor_seed(options.seed, world_seed)) {
  check(options);
  camera.color.check();
  if (camera.color.has_distortion()) {
    throw OptionError("synthetic camera: distortion is not supported; set it to zero");
  }
  add_moving_objects(scene_, T_world_camera_, duration, options.objects,
                     derived_seed(seed_, kObjects));
}

Capture Sensor::capture(std::size_t frame, const Exposure& exposure) const {
  const Motion motion{scene_, camera_.color, T_world_camera_};
  const double readout = options_.exposure.readout;
  const DepthSensor depth_sensor(camera_, options_.depth);
  const int instants = exposure.color ? Sensor::instants(*exposure.color) : 0;

  IdealImages ideal;
  // Colour and depth of one instant share their rays.
  const bool together = instants == 1 && exposure.color == exposure.depth;
  if (exposure.depth) {
    Channels channels = depth_sensor.channels();
    channels.color = together;
    ideal = images_at(motion, *exposure.depth, readout, channels);
  }
  if (exposure.color && !together) ideal.color = light(*exposure.color, instants);

  Capture capture;
  if (exposure.color) {
    const double gain =
        exposure_gain(options_.exposure, derived_seed(seed_, kGain), *exposure.color);
    capture.color =
        expose(ideal.color, gain, options_.image, derived_seed(seed_, kImageNoise, frame));
  }
  if (exposure.depth) {
    capture.depth = depth_sensor.measure(ideal, derived_seed(seed_, kDepthNoise, frame));
  }
  return capture;
}

/// Returns the mean colour image of `instants` times that divide the exposure evenly.
cv::Mat Sensor::light(double seconds, int instants) const {
  const Motion motion{scene_, camera_.color, T_world_camera_};
  const Channels color_alone{.color = true, .depth = false};
  const double readout = options_.exposure.readout;
  if (instants == 1) return images_at(motion, seconds, readout, color_alone).color;
  cv::Mat sum = cv::Mat::zeros(camera_.color.height, camera_.color.width, CV_32FC3);
  for (int i = 0; i < instants; ++i) {
    const double share = (i + 0.5) / instants - 0.5;
    // Each instant casts one ray through the rims, each time another: 4 and 9 have no common
    // divisor.
    const int rim_ray = 4 * i % kRimRays;
    sum +=
        images_at(motion, seconds + share * options_.exposure.time, readout, color_alone, rim_ray)
            .color;
  }
  return sum / instants;
}

int Sensor::instants(double seconds) const {
  constexpr double kStep = 1.5;  // [px]; averaging textures over a pixel hides the steps
  constexpr int kMost = 32;
  if (options_.exposure.time == 0) return 1;
  return std::clamp(static_cast<int>(std::ceil(image_motion(seconds) / kStep)), 1, kMost);
}

/// Returns the largest motion of the image during an exposure [px].
double Sensor::image_motion(double seconds) const {
  constexpr int kGrid = 9;  // positions along each side of the image
  const double half = 0.5 * options_.exposure.time;
  const WorldScene before = scene_at(scene_, seconds - half);
  const WorldScene middle = scene_at(scene_, seconds);
  const WorldScene after = scene_at(scene_, seconds + half);
  const SE3 T_world_camera = T_world_camera_(seconds);
  const SE3 T_before_world = T_world_camera_(seconds - half).inverse();
  const SE3 T_after_world = T_world_camera_(seconds + half).inverse();
  const PinholeCamera& camera = camera_.color;
  const RayCaster rays(middle, camera, T_world_camera);
  double largest = 0;
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const int column = i % kGrid;
    const int row = i / kGrid;
    const Eigen::Vector2d pixel(camera.width * (column + 0.5) / kGrid,
                                camera.height * (row + 0.5) / kGrid);
    const Visible visible = rays.look(pixel.x(), pixel.y());
    if (visible.primitive == Visible::kNothing) continue;
    const auto index = static_cast<std::size_t>(visible.primitive);
    const Vector3 point = T_world_camera * (visible.depth * camera.unproject(pixel));
    const auto seen = [&](const SE3& T_camera_world, const WorldScene& scene) {
      return T_camera_world * carried(point, middle.primitives[index], scene.primitives[index]);
    };
    const Vector3 first = seen(T_before_world, before);
    const Vector3 last = seen(T_after_world, after);
    if (first.z() <= 0 || last.z() <= 0) continue;
    largest = std::max(largest, (camera.project(last) - camera.project(first)).norm());
  }
  return largest;
}

}  // namespace cvo_slam::synthetic
