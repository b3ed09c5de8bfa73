// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/sensor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/core.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/color_sensor_internal.h"
#include "cvo_slam/synthetic/depth_sensor_internal.h"
#include "cvo_slam/synthetic/moving_objects_internal.h"
#include "cvo_slam/synthetic/noise_field_internal.h"
#include "cvo_slam/synthetic/row_views_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// What the seeds of a sensor are for.
enum Purpose : std::int32_t { kObjects, kGain, kImageNoise, kDepthNoise };

Picture picture_at(const Motion& motion, double seconds, double readout, const Channels& channels,
                   std::optional<int> rim_ray = std::nullopt) {
  RowViews views(motion, seconds, readout);
  return draw(
      motion.camera, [&views](int y) -> const View& { return views.of_row(y); }, channels, rim_ray);
}

/// Where a point of a primitive in one scene is in the same scene at another time.
Vector3 carried(const Vector3& point, const Primitive& from, const Primitive& to) {
  return to.T_world_shape * (from.T_world_shape.inverse() * point);
}

}  // namespace

Sensor::Sensor(Scene scene, CameraMotion T_world_camera, double duration, const Camera& camera,
               const SensorOptions& options, std::uint32_t world_seed)
    : scene_(std::move(scene)),
      T_world_camera_(std::move(T_world_camera)),
      camera_(camera),
      options_(options),
      seed_(sensor_seed(options, world_seed)) {
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

  Picture picture;
  // Colour and depth of one instant share their rays.
  const bool together = instants == 1 && exposure.color == exposure.depth;
  if (exposure.depth) {
    Channels channels = depth_sensor.channels();
    channels.color = together;
    picture = picture_at(motion, *exposure.depth, readout, channels);
  }
  if (exposure.color && !together) picture.color = light(*exposure.color, instants);

  Capture capture;
  if (exposure.color) {
    const double gain =
        exposure_gain(options_.exposure, derived_seed(seed_, kGain), *exposure.color);
    capture.color =
        expose(picture.color, gain, options_.image, derived_seed(seed_, kImageNoise, frame));
  }
  if (exposure.depth) {
    capture.depth = depth_sensor.measure(picture, derived_seed(seed_, kDepthNoise, frame));
  }
  return capture;
}

/// The mean of what is seen at `instants` times that divide the exposure evenly.
cv::Mat Sensor::light(double seconds, int instants) const {
  const Motion motion{scene_, camera_.color, T_world_camera_};
  const Channels color_alone{.color = true, .depth = false};
  const double readout = options_.exposure.readout;
  if (instants == 1) return picture_at(motion, seconds, readout, color_alone).color;
  cv::Mat sum = cv::Mat::zeros(camera_.color.height, camera_.color.width, CV_32FC3);
  for (int i = 0; i < instants; ++i) {
    const double share = (i + 0.5) / instants - 0.5;
    // One ray through the rims an instant, each time another; 4 and 9 have no common divisor.
    const int rim_ray = 4 * i % kRimRays;
    sum +=
        picture_at(motion, seconds + share * options_.exposure.time, readout, color_alone, rim_ray)
            .color;
  }
  return sum / instants;
}

int Sensor::instants(double seconds) const {
  constexpr double kStep = 1.5;  // [px]; textures are averaged over a pixel, which hides the steps
  constexpr int kMost = 32;
  if (options_.exposure.time == 0) return 1;
  return std::clamp(static_cast<int>(std::ceil(image_motion(seconds) / kStep)), 1, kMost);
}

/// How far the image moves during an exposure, where it does so most [px].
double Sensor::image_motion(double seconds) const {
  constexpr int kGrid = 9;  // positions along each side of the image
  const double half = 0.5 * options_.exposure.time;
  const Scene before = scene_at(scene_, seconds - half);
  const Scene middle = scene_at(scene_, seconds);
  const Scene after = scene_at(scene_, seconds + half);
  const SE3 T_world_camera = T_world_camera_(seconds);
  const SE3 T_before_world = T_world_camera_(seconds - half).inverse();
  const SE3 T_after_world = T_world_camera_(seconds + half).inverse();
  const PinholeCamera& camera = camera_.color;
  const View view(middle, camera, T_world_camera);
  double largest = 0;
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const int column = i % kGrid;
    const int row = i / kGrid;
    const Eigen::Vector2d pixel(camera.width * (column + 0.5) / kGrid,
                                camera.height * (row + 0.5) / kGrid);
    const Visible visible = view.look(pixel.x(), pixel.y());
    if (visible.primitive == Visible::kNothing) continue;
    const auto index = static_cast<std::size_t>(visible.primitive);
    const Vector3 point = T_world_camera * (visible.depth * camera.unproject(pixel));
    const auto seen = [&](const SE3& T_camera_world, const Scene& scene) {
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
