// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/match_picture.h"

#include <algorithm>
#include <array>

#include <opencv2/imgproc.hpp>

#include "cvo_slam/plot/figure.h"

namespace cvo_slam {
namespace {

constexpr int kGap = 8;  // [px] between the two images
/// So that neighbouring lines are told apart, on dark and on bright images.
constexpr std::array kLineColors = {kSkyBlue, kOrange, kGreen, kPurple, kVermilion};
const cv::Scalar kWhite = cv::Scalar::all(255);
const cv::Scalar kNoImage = cv::Scalar::all(160);

cv::Scalar to_scalar(Color color) {
  return {static_cast<double>(color.blue), static_cast<double>(color.green),
          static_cast<double>(color.red)};
}

/// The image in colour; a field of the other one's size where there is none.
cv::Mat in_color(const cv::Mat& image, const cv::Size& other) {
  if (image.empty()) {
    const cv::Size size = other.empty() ? cv::Size(320, 240) : other;
    return {size, CV_8UC3, kNoImage};
  }
  if (image.channels() == 3) return image;
  cv::Mat color;
  cv::cvtColor(image, color, cv::COLOR_GRAY2BGR);
  return color;
}

cv::Mat side_by_side(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat both(std::max(a.rows, b.rows), a.cols + kGap + b.cols, CV_8UC3, kWhite);
  a.copyTo(both(cv::Rect(0, 0, a.cols, a.rows)));
  b.copyTo(both(cv::Rect(a.cols + kGap, 0, b.cols, b.rows)));
  return both;
}

cv::Mat shrunk(const cv::Mat& image, double scale) {
  cv::Mat result;
  cv::resize(image, result, cv::Size(), scale, scale, cv::INTER_AREA);
  return result;
}

/// The ends of a match on the picture of both images, drawn with a scale.
struct Ends {
  cv::Point2f a;
  cv::Point2f b;
};

std::vector<Ends> ends_of(const std::vector<PixelPair>& pixels, int b_begins, double scale) {
  const auto at = [scale](float u, float v) {
    return cv::Point2f(static_cast<float>(scale * u), static_cast<float>(scale * v));
  };
  std::vector<Ends> ends;
  ends.reserve(pixels.size());
  for (const PixelPair& pair : pixels) {
    ends.push_back({at(pair.a_u, pair.a_v), at(pair.b_u + static_cast<float>(b_begins), pair.b_v)});
  }
  return ends;
}

cv::Scalar color_of(std::size_t match) {
  return to_scalar(kLineColors[match % kLineColors.size()]);
}

/// See-through, so that a hundred lines do not hide what they join.
void draw_lines(const std::vector<Ends>& ends, cv::Mat& picture) {
  constexpr double kOpacity = 0.55;
  cv::Mat lines = picture.clone();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    cv::line(lines, ends[i].a, ends[i].b, color_of(i), 1, cv::LINE_AA);
  }
  cv::addWeighted(lines, kOpacity, picture, 1 - kOpacity, 0, picture);
}

void draw_points(const std::vector<Ends>& ends, cv::Mat& picture) {
  const int radius = std::clamp(picture.cols / 300, 1, 3);  // [px]
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (const cv::Point2f& end : {ends[i].a, ends[i].b}) {
      cv::circle(picture, end, radius + 1, kWhite, cv::FILLED, cv::LINE_AA);
      cv::circle(picture, end, radius, color_of(i), cv::FILLED, cv::LINE_AA);
    }
  }
}

}  // namespace

cv::Mat draw_matches(const cv::Mat& a, const cv::Mat& b, const std::vector<PixelPair>& pixels,
                     int max_width) {
  const cv::Mat left = in_color(a, b.size());
  const cv::Mat right = in_color(b, a.size());
  cv::Mat picture = side_by_side(left, right);
  const double scale = std::min(1.0, static_cast<double>(max_width) / picture.cols);
  if (scale < 1) picture = shrunk(picture, scale);
  const auto ends = ends_of(pixels, left.cols + kGap, scale);
  draw_lines(ends, picture);
  draw_points(ends, picture);
  return picture;
}

}  // namespace cvo_slam
