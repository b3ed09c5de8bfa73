// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <opencv2/core.hpp>

#include "cvo_slam/synthetic/box_filter_internal.h"
#include "cvo_slam/synthetic/image_sensors_internal.h"
#include "cvo_slam/synthetic/random_internal.h"

namespace cvo_slam::synthetic {
namespace {

constexpr double kBaseline = 0.075;                      // of the Kinect [m]
constexpr double kFocalTimesBaseline = 580 * kBaseline;  // of the infrared camera [px m]

/// Rounds a number >= 0 to the nearest integer.
double rounded(double x) { return round_down(x + 0.5); }

/// Returns a / (pi/2 - a), a term of both noise formulas.
double obliqueness(double angle) {
  constexpr double kLargest = 85 * std::numbers::pi / 180;
  const double bounded = std::min(angle, kLargest);
  return bounded / (0.5 * std::numbers::pi - bounded);
}

/// Returns a smooth random process, normally distributed with variance 1 at each time and
/// independent after `period`.
double drift(std::uint32_t seed, double seconds, double period) {
  const double at = seconds / period;
  const double cell = std::floor(at);
  const double s = at - cell;
  // The squares of the two weights sum to 1, which keeps the variance.
  const double angle = 0.5 * std::numbers::pi * s * s * (3 - 2 * s);
  const auto index = static_cast<std::int32_t>(cell);
  return std::cos(angle) * normal(seed, index) + std::sin(angle) * normal(seed, index + 1);
}

/// Returns a normally distributed number of variance 1 that changes at each jump. There is one jump
/// in each interval.
double level(std::uint32_t seed, double seconds, double interval) {
  const double at = seconds / interval;
  const auto index = static_cast<std::int32_t>(std::floor(at));
  const double jump = index + hash_unit(derived_seed(seed, 1), index);
  return normal(seed, at < jump ? index - 1 : index);
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
  // `ray` is the column in the projector's image of its ray to the surface. On a surface without
  // gaps it moves right with the pixel. If it does not, something nearer and farther to the right
  // is in the way.
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

/// Returns an image that is not 0 where depth is missing for no reason in the scene; empty if the
/// option is off.
cv::Mat DepthSensor::gaps(std::uint32_t seed) const {
  if (options_.missing == 0) return {};
  constexpr double kPatch =
      8;  // standard deviation of the filter [px]; patches are three times larger
  const cv::Mat field =
      noise_field(derived_seed(seed, 4), {camera_.color.width, camera_.color.height}, kPatch);
  std::vector<float> levels(field.begin<float>(), field.end<float>());
  const auto missing =
      static_cast<std::ptrdiff_t>(options_.missing * static_cast<double>(levels.size()));
  std::nth_element(levels.begin(), levels.begin() + missing, levels.end());
  return field < levels[static_cast<std::size_t>(missing)];
}

/// Returns the numbers of the surfaces, -1 where the light of the projector does not reach.
cv::Mat DepthSensor::labels(const IdealImages& ideal) const {
  cv::Mat labels(ideal.depth.size(), CV_32SC1, cv::Scalar(0));
  if (!ideal.surface.empty()) ideal.surface.copyTo(labels);
  if (!options_.shadows) return labels;
  for (int y = 0; y < labels.rows; ++y) {
    const auto hidden =
        hidden_from_projector(ideal.depth.ptr<double>(y), labels.cols, camera_.color.fx, kBaseline);
    auto* row = labels.ptr<std::int32_t>(y);
    for (std::size_t x = 0; x < hidden.size(); ++x) {
      if (hidden[x]) row[x] = -1;
    }
  }
  return labels;
}

/// Returns the pixel whose surface is measured at a pixel: itself inside a surface, perhaps one
/// beyond the edge near an edge.
cv::Point DepthSensor::displaced(const IdealImages& ideal, const cv::Mat& labels,
                                 const NoiseFields& noise, const cv::Point& at) const {
  const double sigma = options_.lateral * kinect_lateral_noise(ideal.angle.at<float>(at));
  const auto moved = [sigma](int from, float by, int end) {
    return static_cast<int>(std::clamp(round_down(from + sigma * by + 0.5), 0.0, end - 1.0));
  };
  const cv::Point other(moved(at.x, noise.right.at<float>(at), labels.cols),
                        moved(at.y, noise.down.at<float>(at), labels.rows));
  return labels.at<std::int32_t>(other) == labels.at<std::int32_t>(at) ? at : other;
}

bool DepthSensor::returns_light(const IdealImages& ideal, const cv::Point& at) const {
  if (!ideal.reflectance.empty() && ideal.reflectance.at<float>(at) < options_.min_reflectance) {
    return false;
  }
  return ideal.angle.empty() || ideal.angle.at<float>(at) <= options_.max_incidence;
}

/// Returns the measured depth. `noise` is normally distributed with variance 1.
double DepthSensor::disturbed(double depth, double angle, double noise) const {
  depth *= options_.scale;
  if (options_.axial > 0) {
    const double sigma = options_.axial * kinect_axial_noise(depth, angle);
    const double step = kinect_depth_step(depth, options_.disparity_step);
    // The formula was fitted to quantised depths. The variance of a uniform distribution over one
    // step is subtracted, because the quantisation below adds it again.
    depth += noise * std::sqrt(std::max(0.0, sigma * sigma - step * step / 12));
  }
  if (options_.disparity_step == 0) return depth;
  const double steps = rounded(kFocalTimesBaseline / depth / options_.disparity_step);
  return steps > 0 ? kFocalTimesBaseline / (steps * options_.disparity_step) : 0;
}

/// Returns the depth in units; 0 beyond the range of the sensor or of 16 bits.
std::uint16_t DepthSensor::to_units(double depth) const {
  if (depth < options_.min_range || depth > options_.max_range) return 0;
  const double units = rounded(depth * camera_.depth_scale);
  return units <= 65535 ? static_cast<std::uint16_t>(units) : std::uint16_t{0};
}

cv::Mat DepthSensor::measure(const IdealImages& ideal, std::uint32_t seed) const {
  const NoiseFields noise = noise_fields(seed);
  const cv::Mat surfaces = labels(ideal);
  const cv::Mat gaps = DepthSensor::gaps(seed);
  cv::Mat units = cv::Mat::zeros(ideal.depth.size(), CV_16UC1);
  for (int y = 0; y < units.rows; ++y) {
    for (int x = 0; x < units.cols; ++x) {
      const cv::Point at(x, y);
      if (!gaps.empty() && gaps.at<std::uint8_t>(at) != 0) continue;
      const cv::Point seen = noise.right.empty() ? at : displaced(ideal, surfaces, noise, at);
      const double depth = ideal.depth.at<double>(seen);
      if (depth <= 0 || surfaces.at<std::int32_t>(seen) < 0 || !returns_light(ideal, seen)) {
        continue;
      }
      const double angle = ideal.angle.empty() ? 0 : ideal.angle.at<float>(seen);
      const double along = noise.along.empty() ? 0 : noise.along.at<float>(at);
      units.at<std::uint16_t>(at) = to_units(disturbed(depth, angle, along));
    }
  }
  return units;
}

double exposure_gain(const ExposureOptions& options, std::uint32_t seed, double seconds) {
  return std::exp(options.drift * drift(derived_seed(seed, 1), seconds, options.drift_period) +
                  options.jump * level(derived_seed(seed, 2), seconds, options.jump_interval));
}

cv::Mat expose(const cv::Mat& light, double gain, const ImageNoiseOptions& options,
               std::uint32_t seed) {
  cv::Mat image;
  if (options.read == 0 && options.shot == 0) {
    light.convertTo(image, CV_8UC3, gain);
    return image;
  }
  image.create(light.size(), CV_8UC3);
  const double read_variance = options.read * options.read;
  const double shot_variance = options.shot * options.shot / 255;  // for each grey level
  const int values = light.cols * light.channels();
  for (int y = 0; y < light.rows; ++y) {
    const auto* ideal = light.ptr<float>(y);
    auto* noisy = image.ptr<std::uint8_t>(y);
    for (int i = 0; i < values; ++i) {
      const double signal = gain * static_cast<double>(ideal[i]);
      const double sigma = std::sqrt(read_variance + shot_variance * signal);
      noisy[i] = cv::saturate_cast<std::uint8_t>(signal + sigma * normal(seed, i, y));
    }
  }
  return image;
}

}  // namespace cvo_slam::synthetic
