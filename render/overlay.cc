// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/plot/image_text.h"
#include "cvo_slam/render/line_art_internal.h"
#include "cvo_slam/render/overlay_internal.h"

namespace cvo_slam::render {
namespace {

constexpr Color kInk{40, 44, 48};
constexpr Color kPaper{255, 255, 255};
// Sizes in thin lines.
constexpr double kLabelSize = 11;
constexpr double kLegendSize = 12;
constexpr double kTitleSize = 16;
constexpr double kMargin = 14;

cv::Scalar bgr(Color color) {
  cv::Scalar channels(color.blue, color.green, color.red);
  return channels;
}

std::size_t count_of(const MapScene& scene, EdgeKind kind) {
  return static_cast<std::size_t>(
      std::count_if(scene.constraints.begin(), scene.constraints.end(),
                    [&](const Constraint& constraint) { return constraint.kind == kind; }));
}

}  // namespace

std::vector<LegendEntry> legend_of(const MapScene& scene, const ColorScale& scale) {
  std::vector<LegendEntry> entries;
  for (const Path& path : scene.paths) {
    if (path.label.empty() || path.poses.empty()) continue;
    entries.push_back({path.label, path.color, !path.values.empty() && !scale.empty()});
  }
  const auto add_count = [&](const char* name, std::size_t count, Color color) {
    if (count > 0) entries.push_back({fmt::format("{} ({})", name, count), color});
  };
  add_count("keyframes", scene.keyframes.size(), kKeyframeColor);
  if (scene.paths.empty()) {
    add_count("odometry", count_of(scene, EdgeKind::kOdometry), color_of(EdgeKind::kOdometry));
  }
  add_count("proximity edges", count_of(scene, EdgeKind::kProximity),
            color_of(EdgeKind::kProximity));
  add_count("loop edges", count_of(scene, EdgeKind::kLoop), color_of(EdgeKind::kLoop));
  return entries;
}

int Overlay::px(double units) const { return static_cast<int>(std::lround(units * unit_)); }

void Overlay::text(cv::Point origin, const std::string& text, double size, Color color) {
  // A halo in the colour of paper keeps the text readable on any background.
  draw_image_text(image_, origin, text, size * unit_, kPaper, 3);
  draw_image_text(image_, origin, text, size * unit_, color);
}

bool Overlay::is_free(const cv::Rect& box) const {
  const cv::Rect whole(cv::Point(0, 0), image_.size());
  return (box & whole) == box && std::none_of(taken_.begin(), taken_.end(), [&](const auto& other) {
           return !(box & other).empty();
         });
}

bool Overlay::is_hidden(const Vector3& pixel, const cv::Mat& depth) const {
  if (depth.empty()) return false;
  const auto u = static_cast<int>(std::lround(pixel.x()));
  const auto v = static_cast<int>(std::lround(pixel.y()));
  // The slack keeps the grid line at the position from hiding it.
  const double slack = view_.orthographic ? 1e-3 * (view_.far - view_.near) : 0.01 * pixel.z();
  return depth.at<float>(std::clamp(v, 0, depth.rows - 1), std::clamp(u, 0, depth.cols - 1)) <
         view_.buffer_depth(pixel.z() - slack);
}

void Overlay::draw(const std::vector<Label>& labels, const cv::Mat& depth) {
  for (const Label& label : labels) {
    const Vector3 p = view_.project(label.place);
    const Vector3 q = view_.project(label.away_from);
    if (!view_.orthographic && (p.z() < view_.near || q.z() < view_.near)) continue;
    if (!view_.camera.contains(p.head<2>()) || is_hidden(p, depth)) continue;
    const Eigen::Vector2d away = (p - q).head<2>().stableNormalized();
    const auto extent = image_text_extent(label.text, kLabelSize * unit_);
    // The distance is that of the border of the box, not of its centre.
    const double x = p.x() + away.x() * (0.5 * extent.width + px(7)) - 0.5 * extent.width;
    const double y = p.y() + away.y() * (0.5 * extent.above + px(7)) + 0.5 * extent.above;
    const cv::Point origin(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)));
    const int gap = px(4);
    const cv::Rect box(origin.x - gap, origin.y - extent.above - gap, extent.width + 2 * gap,
                       extent.above + extent.below + 2 * gap);
    if (!is_free(box)) continue;
    taken_.push_back(box);
    text(origin, label.text, kLabelSize, kInk);
  }
}

void Overlay::draw_title(const std::string& title) {
  if (title.empty()) return;
  text({px(kMargin), px(kMargin + 0.8 * kTitleSize)}, title, kTitleSize, kInk);
}

void Overlay::draw_message(const std::string& message) {
  const auto extent = image_text_extent(message, kTitleSize * unit_);
  text({(image_.cols - extent.width) / 2, image_.rows / 2}, message, kTitleSize, kInk);
}

void Overlay::draw_scale(cv::Point origin, int width, const ColorScale& scale,
                         const std::string& value_label) {
  const int height = px(7);
  for (int x = 0; x < width; ++x) {
    const double share = x / std::max(1.0, width - 1.0);
    const Color color = scale(scale.min() + share * (scale.max() - scale.min()));
    cv::line(image_, {origin.x + x, origin.y}, {origin.x + x, origin.y + height}, bgr(color));
  }
  const double size = kLabelSize * unit_;
  const int base = origin.y + height + px(kLabelSize + 2);
  const std::string low = fmt::format("{:.3g}", scale.min());
  const std::string high = fmt::format("{:.3g}", scale.max());
  draw_image_text(image_, {origin.x, base}, low, size, kInk);
  draw_image_text(image_, {origin.x + width - image_text_extent(high, size).width, base}, high,
                  size, kInk);
  const int middle = origin.x + (width - image_text_extent(value_label, size).width) / 2;
  draw_image_text(image_, {middle, base}, value_label, size, kInk);
}

void Overlay::draw_legend(const std::vector<LegendEntry>& entries, const ColorScale& scale,
                          const std::string& value_label) {
  if (entries.empty()) return;
  const int row = px(1.7 * kLegendSize);
  const int pad = px(10);
  const int swatch = px(24);
  const bool has_scale = std::any_of(entries.begin(), entries.end(),
                                     [](const LegendEntry& entry) { return entry.is_scale; });
  int width = has_scale ? px(130) : 0;
  for (const LegendEntry& entry : entries) {
    width =
        std::max(width, swatch + pad + image_text_extent(entry.text, kLegendSize * unit_).width);
  }
  const int height = row * static_cast<int>(entries.size()) + (has_scale ? px(32) : 0);
  const cv::Rect whole(cv::Point(0, 0), image_.size());
  const cv::Rect box = whole & cv::Rect(image_.cols - width - 2 * pad - px(kMargin), px(kMargin),
                                        width + 2 * pad, height + pad);
  cv::Mat paper = image_(box);
  paper = 0.25 * paper + cv::Scalar::all(0.75 * 255);
  taken_.push_back(box);
  const int left = box.x + pad;
  int y = box.y + row / 2 + pad / 2;
  for (const LegendEntry& entry : entries) {
    for (int x = 0; x < swatch; ++x) {
      const double share = x / (swatch - 1.0);
      const Color color =
          entry.is_scale ? scale(scale.min() + share * (scale.max() - scale.min())) : entry.color;
      cv::line(image_, {left + x, y - px(1.5)}, {left + x, y + px(1.5)}, bgr(color));
    }
    draw_image_text(image_, {left + swatch + pad, y + px(0.36 * kLegendSize)}, entry.text,
                    kLegendSize * unit_, kInk);
    y += row;
  }
  if (has_scale) draw_scale({left, y - row / 2 + px(6)}, width, scale, value_label);
}

}  // namespace cvo_slam::render
