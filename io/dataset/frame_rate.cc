// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/dataset/frame_rate_internal.h"
#include "cvo_slam/io/image_files_internal.h"

namespace cvo_slam {
namespace {

constexpr int kWidth = 80;  // [px]; of the images that are compared

cv::Mat small_image(const FrameReader& reader, const std::filesystem::path& file) {
  const cv::Mat color = reader.read_color(file);
  cv::Mat small;
  cv::resize(color, small, {kWidth, std::max(2, kWidth * color.rows / color.cols)}, 0, 0,
             cv::INTER_AREA);
  if (small.channels() == 3) cv::cvtColor(small, small, cv::COLOR_BGR2GRAY);
  cv::Mat values;
  small.convertTo(values, CV_32F);
  return values;
}

/// Returns the angle by which the middle of the image has moved [rad]; empty if the images do not
/// tell. Phase correlation is enough: it need not be right in each pair.
std::optional<double> turn_between(const cv::Mat& from, const cv::Mat& to,
                                   const PinholeCamera& camera) {
  constexpr double kLeastContrast = 3;     // [8-bit values]
  constexpr double kLeastResponse = 0.25;  // of the peak; noise alone gives up to 0.2
  cv::Scalar mean;
  cv::Scalar contrast;
  cv::meanStdDev(from, mean, contrast);
  if (contrast[0] < kLeastContrast) return std::nullopt;
  cv::Mat window;
  cv::createHanningWindow(window, from.size(), CV_32F);
  double response = 0;
  const cv::Point2d shift = cv::phaseCorrelate(from, to, window, &response);
  if (!(response >= kLeastResponse)) return std::nullopt;
  const double scale = static_cast<double>(camera.width) / kWidth;
  return std::hypot(scale * shift.x / camera.fx, scale * shift.y / camera.fy);
}

/// Returns the median speed at which the image turns, by pairs that are spread over the sequence
/// [rad/s]; 0 if most of them do not tell.
double usual_turning_speed(const Sequence& sequence, const Camera& camera) {
  constexpr std::size_t kPairs = 12;
  const auto& frames = sequence.frames;
  const FrameReader reader(camera);
  std::vector<double> speeds;
  for (std::size_t k = 0; k < kPairs && frames.size() > kPairs; ++k) {
    const std::size_t i = k * (frames.size() - 2) / (kPairs - 1);
    try {
      const auto turn = turn_between(small_image(reader, frames[i].color),
                                     small_image(reader, frames[i + 1].color), camera.color);
      if (turn) speeds.push_back(*turn / seconds_between(frames[i].stamp, frames[i + 1].stamp));
    } catch (const InputError&) {  // said when the frame is read
    }
  }
  return speeds.size() < kPairs / 2 ? 0 : summarize(speeds).median;
}

/// Returns the nearest of the rates that are in use.
double rounded(double rate) {
  constexpr std::array kRates = {1.0, 2.0, 3.0, 5.0, 10.0};
  return *std::min_element(kRates.begin(), kRates.end(), [rate](double a, double b) {
    return std::abs(std::log(a / rate)) < std::abs(std::log(b / rate));
  });
}

}  // namespace

std::optional<LikelyFrameRate> likely_frame_rate(const Sequence& sequence, const Camera& camera,
                                                 double rate) {
  // The median of fr1/rpy, one of the fastest recordings there are, is 0.5 rad/s.
  constexpr double kFastest = 0.9;  // [rad/s]
  constexpr double kUsual = 0.3;    // [rad/s]
  const double speed = usual_turning_speed(sequence, camera);
  if (speed < kFastest) return std::nullopt;
  const double likely = rounded(rate * kUsual / speed);
  return LikelyFrameRate{
      likely, fmt::format("frame rate: {} Hz is assumed, because the image turns by {:.1f} degrees "
                          "from frame to frame, too fast for {} Hz; --frame-rate sets it",
                          likely, speed / rate * 180 / std::numbers::pi, rate)};
}

}  // namespace cvo_slam
