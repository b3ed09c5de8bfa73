// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>

#include "cvo_slam/frontend/exposure_internal.h"

namespace cvo_slam {
namespace {

constexpr int kMeanGridStep = 16;  // [px]
/// Range of usable pixels: darker ones are noise, brighter ones may be cut off.
constexpr float kDarkest = 10;
constexpr float kBrightest = 245;
/// Least jump, as a logarithm. The width of the colour kernel allows for smaller changes, and a
/// changing view makes such ones too.
constexpr float kMinJump = 0.15F;
/// Largest interquartile range of the changes, as logarithms. It is 0.1 to 0.2 if the exposure
/// jumps, motion included, and 0.2 to 0.5 if the view changes as in the fast turns of fr1/rpy.
constexpr float kMaxSpread = 0.25F;

/// Returns the quartile number `quarter` of the values, which it reorders.
float quartile(std::span<float> values, std::size_t quarter) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * quarter / 4);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// A camera's exposure has some range; more is an error that has added up.
double bounded(double log_exposure) {
  constexpr double kLargest = 2;  // a factor of 7
  return std::clamp(log_exposure, -kLargest, kLargest);
}

/// Mean of the channels of a pixel.
float brightness(const cv::Mat& image, const cv::Point& pixel) {
  const int channels = image.channels();
  const auto* const values =
      image.ptr<std::uint8_t>(pixel.y) + static_cast<std::ptrdiff_t>(pixel.x) * channels;
  return static_cast<float>(std::accumulate(values, values + channels, 0)) /
         static_cast<float>(channels);
}

/// The same of nine pixels about a pixel. A selected point is the extreme of its surroundings in
/// its own image, and less so in another one.
float brightness_about(const cv::Mat& image, const cv::Point& pixel) {
  constexpr int kStep = 2;
  float sum = 0;
  for (int dv = -kStep; dv <= kStep; dv += kStep) {
    for (int du = -kStep; du <= kStep; du += kStep) {
      sum += brightness(image, {std::clamp(pixel.x + du, 0, image.cols - 1),
                                std::clamp(pixel.y + dv, 0, image.rows - 1)});
    }
  }
  return sum / 9;
}

}  // namespace

double ExposureGain::jump() {
  changes_.clear();
  for (std::size_t i = 0; i < next_.size(); ++i) {
    const auto [low, high] = std::minmax(last_[i], next_[i]);
    if (low < kDarkest || high > kBrightest) continue;
    changes_.push_back(std::log(next_[i] / last_[i]));
  }
  if (2 * changes_.size() < next_.size()) return 0;
  const float spread = quartile(changes_, 3) - quartile(changes_, 1);
  const float median = quartile(changes_, 2);
  return std::abs(median) > kMinJump && spread < kMaxSpread ? median : 0;
}

Exposure ExposureGain::update(const cv::Mat& image) {
  next_.clear();
  for (int v = kMeanGridStep / 2; v < image.rows; v += kMeanGridStep) {
    for (int u = kMeanGridStep / 2; u < image.cols; u += kMeanGridStep) {
      next_.push_back(brightness(image, {u, v}));
    }
  }
  if (!next_.empty() && next_.size() == last_.size()) {
    const double log_jump = jump();
    log_gain_ = bounded(log_gain_ + log_jump);
    log_measured_ = bounded(log_measured_ + log_jump);
  }
  std::swap(last_, next_);
  return exposure();
}

Exposure ExposureGain::observe(const Exposure& keyframe, double log_ratio) {
  log_measured_ = bounded(keyframe.log_measured + log_ratio);
  const double log_keyframe = std::log(keyframe.gain);
  if (std::abs(log_ratio - (log_gain_ - log_keyframe)) > kMinJump) {
    log_gain_ = bounded(log_keyframe + log_ratio);
  }
  return exposure();
}

Exposure ExposureGain::start_keyframe() {
  constexpr double kStep = 0.05;  // so little that the keyframe still matches the one before
  const double difference = log_measured_ - log_gain_;
  if (std::abs(difference) > kMinJump) log_gain_ += std::clamp(difference, -kStep, kStep);
  return exposure();
}

Exposure ExposureGain::exposure() const { return {std::exp(log_gain_), log_measured_}; }

std::optional<double> log_brightness_ratio(const PointCloud& points, const RgbdFrame& frame,
                                           const RgbdFrame& keyframe, const SE3& T_keyframe_frame,
                                           const Camera& camera, const FieldOfView& field_of_view) {
  constexpr std::size_t kFewest = 100;   // points
  constexpr std::size_t kMost = 400;     // the first ones are spread over the image as all are
  constexpr double kSameSurface = 0.05;  // of the depth
  std::array<float, kMost> changes{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(kMost, points.size()); ++i) {
    const Vector3 point = T_keyframe_frame * points.position(i);
    if (!field_of_view.contains(point)) continue;
    const Eigen::Vector2d seen = camera.color.project(point);
    const cv::Point pixel(cvRound(seen.x()), cvRound(seen.y()));
    if (!cv::Rect({}, keyframe.color.size()).contains(pixel)) continue;
    const double depth = keyframe.depth.at<std::uint16_t>(pixel) / camera.depth_scale;
    if (std::abs(depth - point.z()) > kSameSurface * point.z()) continue;
    const float now = brightness_about(frame.color, {cvRound(points.u[i]), cvRound(points.v[i])});
    const float before = brightness_about(keyframe.color, pixel);
    const auto [low, high] = std::minmax(now, before);
    if (low >= kDarkest && high <= kBrightest) changes[count++] = std::log(now / before);
  }
  if (count < kFewest) return std::nullopt;
  return quartile(std::span(changes).first(count), 2);
}

}  // namespace cvo_slam
