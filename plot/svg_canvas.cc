// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/plot/canvas_internal.h"
#include "cvo_slam/plot/image_data.h"

namespace cvo_slam {
namespace {

/// Returns the text with XML's own characters escaped. Control characters, which XML forbids,
/// become blanks.
std::string escape(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

/// Rounds to a hundredth of a pixel. 0.0 is added so that no "-0" appears.
double rounded(double value) { return std::round(value * 100) / 100 + 0.0; }

std::string hex(Color color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue);
}

std::string_view name_of(TextAnchor anchor) {
  switch (anchor) {
    case TextAnchor::kStart:
      return "start";
    case TextAnchor::kMiddle:
      return "middle";
    case TextAnchor::kEnd:
      return "end";
  }
  return "";
}

class SvgCanvas : public Canvas {
 public:
  SvgCanvas(int width, int height) : width_(width), height_(height) {}

  void polyline(const std::vector<CanvasPoint>& points, const LineStyle& style) override {
    body_ += R"(<polyline fill="none" points=")";
    for (const auto& point : points) {
      body_ += fmt::format("{}{},{}", &point == points.data() ? "" : " ", rounded(point.x),
                           rounded(point.y));
    }
    body_ +=
        fmt::format(R"(" stroke="{}" stroke-width="{}")", hex(style.color), rounded(style.width));
    std::vector<double> lengths = dashes(style);
    for (double& length : lengths) length = rounded(length);
    if (!lengths.empty()) {
      body_ += fmt::format(" stroke-dasharray=\"{}\"", fmt::join(lengths, " "));
    }
    body_ += "/>\n";
  }

  void image(const CanvasRectangle& place, const cv::Mat& pixels) override {
    body_ += fmt::format(
        "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
        "xlink:href=\"data:image/png;base64,{}\"/>\n",
        rounded(place.left), rounded(place.top), rounded(place.width()), rounded(place.height()),
        to_base64(encode_png(pixels)));
    has_image_ = true;
  }

  void disc(CanvasPoint center, double radius, Color color) override {
    body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", rounded(center.x),
                         rounded(center.y), rounded(radius), hex(color));
  }

  void text(CanvasPoint position, const std::string& text, const TextStyle& style) override {
    if (text.empty()) return;
    const double x = rounded(position.x);
    const double y = rounded(position.y);
    const std::string turn =
        style.vertical ? fmt::format(" transform=\"rotate(-90 {} {})\"", x, y) : "";
    body_ += fmt::format(
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", x,
        y, style.size, hex(style.color), name_of(style.anchor), turn, escape(text));
  }

  [[nodiscard]] std::string file_bytes() const override {
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" {3}version=\"1.1\" width=\"{0}\" "
        "height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"
        "<g font-family=\"Helvetica, Arial, sans-serif\" stroke-linejoin=\"round\">\n"
        "{2}</g>\n</svg>\n",
        width_, height_, body_, has_image_ ? "xmlns:xlink=\"http://www.w3.org/1999/xlink\" " : "");
  }

 private:
  int width_;
  int height_;
  std::string body_;
  bool has_image_ = false;
};

}  // namespace

std::unique_ptr<Canvas> make_svg_canvas(int width, int height) {
  return std::make_unique<SvgCanvas>(width, height);
}

}  // namespace cvo_slam
