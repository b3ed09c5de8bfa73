// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <opencv2/core.hpp>

#include "cvo_slam/synthetic/box_filter_internal.h"
#include "cvo_slam/synthetic/depth_sensor_internal.h"
#include "cvo_slam/synthetic/noise_field_internal.h"

namespace cvo_slam::synthetic {
namespace {

constexpr double kBaseline = 0.075;                      // of a Kinect [m]
constexpr double kFocalTimesBaseline = 580 * kBaseline;  // of its infrared camera [px m]

/// To the nearest integer, of a number that is not negative.
double rounded(double x) { return round_down(x + 0.5); }

/// a / (pi/2 - a), which both formulas of the noise share.
double obliqueness(double angle) {
  constexpr double kLargest = 85 * std::numbers::pi / 180;
  const double bounded = std::min(angle, kLargest);
  return bounded / (0.5 * std::numbers::pi - bounded);
}

}  // namespace

double kinect_axial_noise(double z, double angle) {
  const double slanted = obliqueness(angle);
  return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4) + 0.0001 / std::sqrt(z) * slanted * slanted;
}

double kinect_lateral_noise(double angle) { return 0.8 + 0.035 * obliqueness(angle); }

double kinect_depth_step(double z, double step) { return z * z * step / kFocalTimesBaseline; }

std::vector<bool> hidden_from_projector(const double* depths, int width, double fx,
                                        double baseline) {
  // Where the projector's ray to a pixel's surface runs in the projector's own image. From a
  // surface without gaps it moves right with the pixel; where it does not, something nearer and
  // further to the right is in the way.
  std::vector<bool> hidden(static_cast<std::size_t>(width), false);
  double leftmost = std::numeric_limits<double>::infinity();
  for (int x = width - 1; x >= 0; --x) {
    if (depths[x] <= 0) continue;
    const double ray = x - fx * baseline / depths[x];
    hidden[static_cast<std::size_t>(x)] = ray >= leftmost;
    leftmost = std::min(leftmost, ray);
  }
  return hidden;
}

Channels DepthSensor::channels() const {
  const bool slant_matters = options_.axial > 0 || options_.max_incidence < 0.5 * std::numbers::pi;
  return {.color = false,
          .depth = true,
          .geometry = slant_matters || options_.lateral > 0,
          .reflectance = options_.min_reflectance > 0};
}

DepthSensor::NoiseFields DepthSensor::noise_fields(std::uint32_t seed) const {
  const cv::Size size(camera_.color.width, camera_.color.height);
  const auto field = [&](double strength, std::int32_t purpose) {
    return strength > 0 ? noise_field(derived_seed(seed, purpose), size, options_.correlation)
                        : cv::Mat();
  };
  return {field(options_.axial, 1), field(options_.lateral, 2), field(options_.lateral, 3)};
}

/// Not 0 where depth is missing without any reason in the scene; empty where it never is.
cv::Mat DepthSensor::gaps(std::uint32_t seed) const {
  if (options_.missing == 0) return {};
  constexpr double kPatch = 8;  // [px]; standard deviation of the filter, patches are about thrice
  const cv::Mat field =
      noise_field(derived_seed(seed, 4), {camera_.color.width, camera_.color.height}, kPatch);
  std::vector<float> levels(field.begin<float>(), field.end<float>());
  const auto missing =
      static_cast<std::ptrdiff_t>(options_.missing * static_cast<double>(levels.size()));
  std::nth_element(levels.begin(), levels.begin() + missing, levels.end());
  return field < levels[static_cast<std::size_t>(missing)];
}

/// The surfaces' numbers, -1 where the projector's light does not come.
cv::Mat DepthSensor::labels(const Picture& picture) const {
  cv::Mat labels(picture.depth.size(), CV_32SC1, cv::Scalar(0));
  if (!picture.surface.empty()) picture.surface.copyTo(labels);
  if (!options_.shadows) return labels;
  for (int y = 0; y < labels.rows; ++y) {
    const auto hidden = hidden_from_projector(picture.depth.ptr<double>(y), labels.cols,
                                              camera_.color.fx, kBaseline);
    auto* row = labels.ptr<std::int32_t>(y);
    for (std::size_t x = 0; x < hidden.size(); ++x) {
      if (hidden[x]) row[x] = -1;
    }
  }
  return labels;
}

/// The pixel whose surface is measured at a pixel: within a surface itself, at an edge perhaps one
/// beyond it.
cv::Point DepthSensor::displaced(const Picture& picture, const cv::Mat& labels,
                                 const NoiseFields& noise, const cv::Point& at) const {
  const double sigma = options_.lateral * kinect_lateral_noise(picture.angle.at<float>(at));
  const auto moved = [sigma](int from, float by, int end) {
    return static_cast<int>(std::clamp(round_down(from + sigma * by + 0.5), 0.0, end - 1.0));
  };
  const cv::Point other(moved(at.x, noise.right.at<float>(at), labels.cols),
                        moved(at.y, noise.down.at<float>(at), labels.rows));
  return labels.at<std::int32_t>(other) == labels.at<std::int32_t>(at) ? at : other;
}

bool DepthSensor::returns_light(const Picture& picture, const cv::Point& at) const {
  if (!picture.reflectance.empty() &&
      picture.reflectance.at<float>(at) < options_.min_reflectance) {
    return false;
  }
  return picture.angle.empty() || picture.angle.at<float>(at) <= options_.max_incidence;
}

/// The depth that is measured, where `noise` is normally distributed with variance 1.
double DepthSensor::disturbed(double depth, double angle, double noise) const {
  if (options_.axial > 0) {
    const double sigma = options_.axial * kinect_axial_noise(depth, angle);
    const double step = kinect_depth_step(depth, options_.disparity_step);
    // The formula was fitted to quantised depths: the part of the steps, within which depths are
    // uniformly distributed, comes by itself.
    depth += noise * std::sqrt(std::max(0.0, sigma * sigma - step * step / 12));
  }
  if (options_.disparity_step == 0) return depth;
  const double steps = rounded(kFocalTimesBaseline / depth / options_.disparity_step);
  return steps > 0 ? kFocalTimesBaseline / (steps * options_.disparity_step) : 0;
}

/// What is beyond the range of the sensor or of 16 bits is left without depth.
std::uint16_t DepthSensor::to_units(double depth) const {
  if (depth < options_.min_range || depth > options_.max_range) return 0;
  const double units = rounded(depth * camera_.depth_scale);
  return units <= 65535 ? static_cast<std::uint16_t>(units) : std::uint16_t{0};
}

cv::Mat DepthSensor::measure(const Picture& picture, std::uint32_t seed) const {
  const NoiseFields noise = noise_fields(seed);
  const cv::Mat surfaces = labels(picture);
  const cv::Mat gaps = DepthSensor::gaps(seed);
  cv::Mat units = cv::Mat::zeros(picture.depth.size(), CV_16UC1);
  for (int y = 0; y < units.rows; ++y) {
    for (int x = 0; x < units.cols; ++x) {
      const cv::Point at(x, y);
      if (!gaps.empty() && gaps.at<std::uint8_t>(at) != 0) continue;
      const cv::Point seen = noise.right.empty() ? at : displaced(picture, surfaces, noise, at);
      const double depth = picture.depth.at<double>(seen);
      if (depth <= 0 || surfaces.at<std::int32_t>(seen) < 0 || !returns_light(picture, seen)) {
        continue;
      }
      const double angle = picture.angle.empty() ? 0 : picture.angle.at<float>(seen);
      const double along = noise.along.empty() ? 0 : noise.along.at<float>(at);
      units.at<std::uint16_t>(at) = to_units(disturbed(depth, angle, along));
    }
  }
  return units;
}

}  // namespace cvo_slam::synthetic
