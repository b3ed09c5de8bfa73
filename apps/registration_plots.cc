// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/registration_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/apps/evaluation_plots.h"
#include "cvo_slam/apps/sparsity_image.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/render/picture.h"

namespace cvo_slam {
namespace {

/// Samples a curve over t / unit; the line is broken where it leaves [-limit, limit].
template <typename Curve>
Series sampled(double begin, double end, double unit, double limit, const Curve& curve) {
  constexpr int kSamples = 80;
  Series series;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = begin + (end - begin) * i / kSamples;
    const double value = curve(t);
    series.x.push_back(t / unit);
    series.y.push_back(std::abs(value) <= limit ? value : std::numeric_limits<double>::quiet_NaN());
  }
  return series;
}

/// The style of the line of an expansion.
struct ExpansionStyle {
  int order;
  const char* name;
  Color color;
  LinePattern pattern;
};

constexpr std::array kExpansions = {
    ExpansionStyle{2, "2nd order", kVermilion, LinePattern::kDashed},
    ExpansionStyle{4, "4th order", kBlue, LinePattern::kSolid}};

void add_curves(const StepCurve& curve, double begin, double end, double unit,
                std::vector<Series>& series) {
  const auto exact = [&](double t) { return curve.exact(t); };
  // The line of an expansion ends where it is far from the curve.
  const double limit =
      1.6 * std::max({std::abs(exact(begin)), std::abs(exact(end)), exact(curve.step(4))});
  const auto add = [&](Series line, const char* label, Color color, double width) {
    line.label = label;
    line.color = color;
    line.width = width;
    series.push_back(std::move(line));
  };
  add(sampled(begin, end, unit, limit, exact), "exact", kGrey, 5);
  for (const ExpansionStyle& style : kExpansions) {
    add(sampled(begin, end, unit, limit, [&](double t) { return curve.expanded(t, style.order); }),
        style.name, style.color, 2);
    series.back().pattern = style.pattern;
  }
}

/// Adds the steps that the expansions choose, on the exact curve.
void add_steps(const StepCurve& curve, double unit, std::vector<Series>& series) {
  constexpr double kRadius = 6;  // [px]
  for (const ExpansionStyle& style : kExpansions) {
    const double t = curve.step(style.order);
    series.push_back({fmt::format("step of {}", style.name),
                      {t / unit},
                      {curve.exact(t)},
                      style.color,
                      SeriesStyle::kPoints,
                      kRadius});
  }
}

constexpr Color kColorOfA = kBlue;
constexpr Color kColorOfB = kOrange;

/// Replaces the colours of points by shades of one colour with the same brightness.
void tint(std::vector<MapPoint>& points, Color color) {
  for (MapPoint& point : points) {
    const auto& [red, green, blue] = point.color;
    const double light = (0.3 * red + 0.59 * green + 0.11 * blue) / 255;
    const auto shade = [&](std::uint8_t value) {
      // From half the colour to two thirds of the way to white.
      const double dark = value / 2.0;
      const double bright = value + (255 - value) * 2 / 3.0;
      return static_cast<std::uint8_t>(std::lround(dark + light * (bright - dark)));
    };
    point.color = {shade(color.red), shade(color.green), shade(color.blue)};
  }
}

/// Returns the surface that a frame saw, in shades of one colour.
std::vector<MapPoint> surface_of(const RgbdFrame& frame, const Camera& camera, const SE3& T_a_frame,
                                 Color color) {
  FusionOptions options;
  options.pixel_step = 2;
  options.voxel_size = 0.01;
  options.min_samples = 1;  // a single frame sees most places once
  options.max_depth = 6;
  const PosedFrame posed{sample_frame(frame, options.pixel_step), T_a_frame};
  auto points = fuse_points({&posed, 1}, camera, options);
  tint(points, color);
  return points;
}

double median_depth(const PointCloud& cloud) {
  std::vector<float> depths = cloud.z;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

/// Returns a view from the right of camera a and above it, which also shows depth.
render::MapView view_beside(const FramePair& pair, double depth) {
  constexpr double kWidth = 880;  // [px]
  constexpr double kAzimuth = -18 * std::numbers::pi / 180;
  constexpr double kElevation = -10 * std::numbers::pi / 180;
  constexpr double kBack = 1.2;  // times the depth
  const PinholeCamera& camera = pair.camera.color;
  const double scale = kWidth / camera.width;
  render::MapView view;
  view.camera = {.width = static_cast<int>(kWidth),
                 .height = static_cast<int>(std::lround(scale * camera.height)),
                 .fx = scale * std::abs(camera.fx),
                 .fy = scale * camera.fy,  // negative where y is up
                 .cx = (kWidth - 1) / 2,
                 .cy = (scale * camera.height - 1) / 2};
  const Matrix3 rotation = so3_exp({0, kAzimuth, 0}) * so3_exp({kElevation, 0, 0});
  const Vector3 center(0, 0, depth);
  view.T_world_view = SE3(rotation, center - rotation * (kBack * center));
  return view;
}

Panel surface_panel(const std::string& title, const FramePair& pair, const SE3& T_a_b,
                    const render::MapView& view, render::Renderer& renderer) {
  render::MapScene scene;
  scene.ground = false;
  scene.points = surface_of(pair.a, pair.camera, SE3(), kColorOfA);
  const auto points_of_b = surface_of(pair.b, pair.camera, T_a_b, kColorOfB);
  scene.points.insert(scene.points.end(), points_of_b.begin(), points_of_b.end());
  Panel panel;
  panel.title = title;
  panel.image = in_pixels(render::draw_picture(scene, view, renderer).image);
  panel.equal_aspect = true;
  panel.scales = false;
  panel.span = 4;
  constexpr double kSample = 6;  // [px]
  panel.series = {{"a: " + pair.name_a, {}, {}, kColorOfA, SeriesStyle::kPoints, kSample},
                  {"b: " + pair.name_b, {}, {}, kColorOfB, SeriesStyle::kPoints, kSample}};
  return panel;
}

/// Returns the pixels at which points appear in the image of a; a point behind the camera keeps its
/// own pixel.
std::vector<Eigen::Vector2d> pixels_in_a(const PointCloud& points, const SE3& T_a_points,
                                         const PinholeCamera& camera) {
  std::vector<Eigen::Vector2d> pixels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 place = T_a_points * points.position(i);
    pixels.push_back(place.z() > 0 ? camera.project(place)
                                   : Eigen::Vector2d(points.u[i], points.v[i]));
  }
  return pixels;
}

/// Draws the kernel matrix with both clouds in the order of the pixels of a, so that matching
/// points are near the diagonal.
Panel sparsity_panel(const FramePair& pair, const FrameRegistration& registration, const SE3& T_a_b,
                     const CloudSimilarity& similarity, const KernelOptions& kernel) {
  constexpr int kSide = 600;  // [px]
  const PointCloud& a = registration.points_a;
  const PointCloud& b = registration.points_b;
  const auto entries = kernel_matrix(a, b, T_a_b, kernel, registration.length_scale);
  Panel panel;
  panel.title = fmt::format("{} entries, cos_theta {:.3f}", entries.size(), similarity.cos_theta);
  panel.x_label = fmt::format("{} points of b", b.size());
  panel.y_label = fmt::format("{} points of a", a.size());
  const PinholeCamera& camera = pair.camera.color;
  const auto rows = ranks_along_curve(pixels_in_a(a, SE3(), camera));
  const auto columns =
      ranks_along_curve(pixels_in_a(b, registration.result.T_fixed_moving, camera));
  panel.image = in_pixels(draw_sparsity(entries, rows, columns, {kSide, kSide}));
  panel.equal_aspect = true;
  panel.scales = false;
  panel.span = 3;
  return panel;
}

/// Both frames' surfaces from one view before and after the registration, a in shades of blue and b
/// in shades of orange, each beside the sparsity pattern of the kernel matrix at the last length
/// scale.
Figure registration_figure(const FramePair& pair, const FrameRegistration& registration,
                           const KernelOptions& kernel) {
  const auto renderer = render::make_renderer();
  const render::MapView view = view_beside(pair, median_depth(registration.points_a));
  const SE3& T = registration.result.T_fixed_moving;
  Figure figure;
  figure.columns = 7;
  figure.width = 1300;
  figure.height = 1140;
  figure.panels = {surface_panel("before", pair, SE3(), view, *renderer),
                   sparsity_panel(pair, registration, SE3(), registration.before, kernel),
                   surface_panel(fmt::format("after {} iterations", registration.result.iterations),
                                 pair, T, view, *renderer),
                   sparsity_panel(pair, registration, T, registration.after, kernel)};
  return figure;
}

}  // namespace

Figure step_figure(const StepCurve& curve) {
  Figure figure;
  figure.width = 1000;
  figure.height = 620;
  figure.panels = {{}};
  Panel& panel = figure.panels[0];
  panel.title = fmt::format("Objective along a step of the gradient flow, length scale {} m",
                            curve.length_scale());
  panel.y_label = "G(t) = F(h exp(t xi)) - F(h)";
  if (!curve.has_slope()) return figure;
  const double longest = std::max(curve.step(2), curve.step(4));
  // The time of the flow is far below 1, and is given in a power of ten.
  const double power = std::floor(std::log10(longest));
  panel.x_label = fmt::format("t [1e{:.0f}]", power);
  add_curves(curve, -0.4 * longest, 1.6 * longest, std::pow(10, power), panel.series);
  add_steps(curve, std::pow(10, power), panel.series);
  return figure;
}

void write_registration_plots(const std::filesystem::path& folder, const FramePair& pair,
                              const FrameRegistration& registration,
                              const RegistrationOptions& options) {
  make_folder(folder);
  write_figure(folder / "registration", registration_figure(pair, registration, options.kernel));
  const StepCurve curve(registration.points_a, registration.points_b, SE3(), options.kernel,
                        options.flow, options.length_scales.front());
  write_figure(folder / "step", step_figure(curve));
}

}  // namespace cvo_slam
