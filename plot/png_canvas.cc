// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "cvo_slam/plot/canvas_internal.h"
#include "cvo_slam/plot/image_data.h"
#include "cvo_slam/plot/image_text.h"

namespace cvo_slam {
namespace {

/// The picture is drawn this much larger and then shrunk: the strokes of OpenCV's fonts need the
/// pixels.
constexpr int kOversampling = 3;
/// Number of fractional bits of the coordinates that OpenCV draws with.
constexpr int kShift = 4;

cv::Scalar bgr(Color color) {
  return {static_cast<double>(color.blue), static_cast<double>(color.green),
          static_cast<double>(color.red)};
}

cv::Point fixed_point(CanvasPoint point) {
  constexpr double kUnit = kOversampling * (1 << kShift);
  return {static_cast<int>(std::lround(point.x * kUnit)),
          static_cast<int>(std::lround(point.y * kUnit))};
}

int line_thickness(double width) {
  return std::max(1, static_cast<int>(std::lround(width * kOversampling)));
}

int pixel_of(double coordinate) {
  return static_cast<int>(std::lround(coordinate * kOversampling));
}

/// A text as a small image, dark on white.
struct TextImage {
  cv::Mat pixels;
  int baseline = 0;  ///< number of rows above the base line
};

TextImage render_text(const std::string& text, const TextStyle& style) {
  const double size = style.size * kOversampling;
  const ImageTextExtent extent = image_text_extent(text, size);
  const int margin = extent.thickness;
  TextImage image;
  image.baseline = extent.above + margin;
  image.pixels.create(extent.above + extent.below + 2 * margin, extent.width + 2 * margin, CV_8UC3);
  image.pixels.setTo(cv::Scalar::all(255));
  draw_image_text(image.pixels, {margin, image.baseline}, text, size, style.color);
  return image;
}

double share_before(TextAnchor anchor) {
  switch (anchor) {
    case TextAnchor::kStart:
      return 0;
    case TextAnchor::kMiddle:
      return 0.5;
    case TextAnchor::kEnd:
      return 1;
  }
  return 0;
}

class PngCanvas : public Canvas {
 public:
  PngCanvas(int width, int height)
      : size_(width, height),
        image_(height * kOversampling, width * kOversampling, CV_8UC3, cv::Scalar::all(255)) {}

  void polyline(const std::vector<CanvasPoint>& points, const LineStyle& style) override {
    for (const auto& stroke : strokes_of(points, dashes(style))) {
      std::vector<cv::Point> fixed(stroke.size());
      std::transform(stroke.begin(), stroke.end(), fixed.begin(), fixed_point);
      cv::polylines(image_, fixed, false, bgr(style.color), line_thickness(style.width),
                    cv::LINE_AA, kShift);
    }
  }

  void image(const CanvasRectangle& place, const cv::Mat& pixels) override {
    const cv::Rect whole(0, 0, image_.cols, image_.rows);
    const cv::Point upper_left(pixel_of(place.left), pixel_of(place.top));
    const cv::Rect target(upper_left, cv::Point(pixel_of(place.right), pixel_of(place.bottom)));
    const cv::Rect seen = target & whole;
    if (seen.empty()) return;
    cv::Mat scaled;
    const bool shrinks = target.width < pixels.cols;
    cv::resize(pixels, scaled, target.size(), 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
    scaled(seen - upper_left).copyTo(image_(seen));
  }

  void disc(CanvasPoint center, double radius, Color color) override {
    const int fixed_radius = static_cast<int>(std::lround(radius * kOversampling * (1 << kShift)));
    cv::circle(image_, fixed_point(center), fixed_radius, bgr(color), cv::FILLED, cv::LINE_AA,
               kShift);
  }

  void text(CanvasPoint position, const std::string& text, const TextStyle& style) override {
    if (text.empty()) return;
    const TextImage rendered = render_text(text, style);
    const int before =
        static_cast<int>(std::lround(share_before(style.anchor) * rendered.pixels.cols));
    const cv::Point origin(pixel_of(position.x), pixel_of(position.y));
    if (!style.vertical) {
      paste(rendered.pixels, origin - cv::Point(before, rendered.baseline));
      return;
    }
    cv::Mat turned;
    cv::rotate(rendered.pixels, turned, cv::ROTATE_90_COUNTERCLOCKWISE);
    paste(turned, origin - cv::Point(rendered.baseline, turned.rows - before));
  }

  [[nodiscard]] std::string file_bytes() const override {
    cv::Mat shrunk;
    cv::resize(image_, shrunk, size_, 0, 0, cv::INTER_AREA);
    return encode_png(shrunk);
  }

 private:
  /// Darkens the picture by the part of `pixels` that lies inside it.
  void paste(const cv::Mat& pixels, const cv::Point& origin) {
    const cv::Rect whole(0, 0, image_.cols, image_.rows);
    const cv::Rect target = whole & cv::Rect(origin, pixels.size());
    if (target.empty()) return;
    cv::Mat part = image_(target);
    cv::min(part, pixels(target - origin), part);
  }

  cv::Size size_;
  cv::Mat image_;
};

}  // namespace

std::unique_ptr<Canvas> make_png_canvas(int width, int height) {
  return std::make_unique<PngCanvas>(width, height);
}

}  // namespace cvo_slam
