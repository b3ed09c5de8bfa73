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

#include "cvo_slam/apps/sparsity_image.h"
#include "cvo_slam/core/point_fusion.h"
#include "cvo_slam/io/file_output.h"
#include "cvo_slam/io/plot/plot_file.h"
#include "cvo_slam/io/render/picture.h"

namespace cvo_slam {
namespace {

constexpr Color kColorOfA = kBlue;
constexpr Color kColorOfB = kOrange;

/// Shades of one colour from dark to light, as the point was.
void tint(std::vector<MapPoint>& points, Color color) {
  for (MapPoint& point : points) {
    const auto& [red, green, blue] = point.color;
    const double light = (0.3 * red + 0.59 * green + 0.11 * blue) / 255;
    const auto shade = [&](std::uint8_t value) {
      // From a third of the colour to two thirds of the way to white.
      const double dark = value / 3.0;
      const double bright = value + (255 - value) * 2 / 3.0;
      return static_cast<std::uint8_t>(std::lround(dark + light * (bright - dark)));
    };
    point.color = {shade(color.red), shade(color.green), shade(color.blue)};
  }
}

/// What a frame saw, in one colour.
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

/// From the right of camera a and above it: so that depth is seen too.
render::View view_beside(const FramePair& pair, double depth) {
  constexpr double kWidth = 880;  // [px]
  constexpr double kAzimuth = -18 * std::numbers::pi / 180;
  constexpr double kElevation = -10 * std::numbers::pi / 180;
  constexpr double kBack = 1.2;  // times the depth
  const PinholeCamera& camera = pair.camera.color;
  const double scale = kWidth / camera.width;
  render::View view;
  view.camera = {.width = static_cast<int>(kWidth),
                 .height = static_cast<int>(std::lround(scale * camera.height)),
                 .fx = scale * std::abs(camera.fx),
                 .fy = scale * std::abs(camera.fx),
                 .cx = (kWidth - 1) / 2,
                 .cy = (scale * camera.height - 1) / 2};
  const Matrix3 rotation = so3_exp({0, kAzimuth, 0}) * so3_exp({kElevation, 0, 0});
  const Vector3 center(0, 0, depth);
  view.T_world_view = SE3(rotation, center - rotation * (kBack * center));
  return view;
}

Panel surface_panel(const std::string& title, const FramePair& pair, const SE3& T_a_b,
                    const render::View& view, render::Renderer& renderer) {
  render::Scene scene;
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

Panel sparsity_panel(const FrameRegistration& registration, const SE3& T_a_b,
                     const CloudSimilarity& similarity, const KernelOptions& kernel) {
  constexpr int kSide = 600;  // [px]
  const PointCloud& a = registration.points_a;
  const PointCloud& b = registration.points_b;
  const auto entries = kernel_matrix(a, b, T_a_b, kernel, registration.length_scale);
  Panel panel;
  panel.title = fmt::format("{} entries, cos_theta {:.3f}", entries.size(), similarity.cos_theta);
  panel.x_label = fmt::format("{} points of b", b.size());
  panel.y_label = fmt::format("{} points of a", a.size());
  panel.image = in_pixels(draw_sparsity(entries, a, b, {kSide, kSide}));
  panel.equal_aspect = true;
  panel.scales = false;
  panel.span = 3;
  return panel;
}

/// Samples of a curve; where it leaves [-limit, limit] it is broken.
template <typename Curve>
Series sampled(std::string label, double begin, double end, double limit, const Curve& curve) {
  constexpr int kSamples = 200;
  Series series;
  series.label = std::move(label);
  for (int i = 0; i <= kSamples; ++i) {
    const double t = begin + (end - begin) * i / kSamples;
    const double value = curve(t);
    series.x.push_back(t);
    series.y.push_back(std::abs(value) <= limit ? value : std::numeric_limits<double>::quiet_NaN());
  }
  return series;
}

void write_both(const std::filesystem::path& stem, const Figure& figure) {
  write_png(stem.string() + ".png", figure);
  write_svg(stem.string() + ".svg", figure);
}

}  // namespace

Figure registration_figure(const FramePair& pair, const FrameRegistration& registration,
                           const KernelOptions& kernel) {
  const auto renderer = render::make_renderer();
  const render::View view = view_beside(pair, median_depth(registration.points_a));
  const SE3& T = registration.result.T_fixed_moving;
  Figure figure;
  figure.columns = 7;
  figure.width = 1300;
  figure.height = 1140;
  figure.panels = {surface_panel("before", pair, SE3(), view, *renderer),
                   sparsity_panel(registration, SE3(), registration.before, kernel),
                   surface_panel(fmt::format("after {} iterations", registration.result.iterations),
                                 pair, T, view, *renderer),
                   sparsity_panel(registration, T, registration.after, kernel)};
  return figure;
}

Figure step_figure(const StepCurve& curve) {
  Figure figure;
  figure.width = 900;
  figure.height = 620;
  figure.panels = {
      {fmt::format("Objective along a step of the flow, length scale {} m", curve.length_scale()),
       "t",
       "G(t) = F(h exp(t xi)) - F(h)",
       {}}};
  if (!curve.has_slope()) return figure;
  const std::array<double, 2> steps = {curve.step(2), curve.step(4)};
  const double longest = std::max(steps[0], steps[1]);
  const double begin = -0.4 * longest;
  const double end = 2.2 * longest;
  const auto exact = [&](double t) { return curve.exact(t); };
  const double limit = 1.3 * std::max({std::abs(exact(begin)), std::abs(exact(end)),
                                       exact(steps[0]), exact(steps[1])});
  auto& series = figure.panels[0].series;
  const auto add = [&](Series line, Color color, double width, LinePattern pattern) {
    line.color = color;
    line.width = width;
    line.pattern = pattern;
    series.push_back(std::move(line));
  };
  add(sampled("exact", begin, end, limit, exact), kGrey, 5, LinePattern::kSolid);
  constexpr std::array kOrders = {2, 4};
  constexpr std::array kNames = {"2nd order", "4th order"};
  constexpr std::array kColors = {kVermilion, kBlue};
  constexpr std::array kPatterns = {LinePattern::kDashed, LinePattern::kSolid};
  for (std::size_t i = 0; i < kOrders.size(); ++i) {
    add(sampled(kNames.at(i), begin, end, limit,
                [&](double t) { return curve.expanded(t, kOrders.at(i)); }),
        kColors.at(i), 2, kPatterns.at(i));
  }
  for (std::size_t i = 0; i < kOrders.size(); ++i) {
    series.push_back({fmt::format("its step, t = {:.3g}", steps.at(i)),
                      {steps.at(i)},
                      {exact(steps.at(i))},
                      kColors.at(i),
                      SeriesStyle::kPoints,
                      6});
  }
  return figure;
}

void write_registration_plots(const std::filesystem::path& folder, const FramePair& pair,
                              const FrameRegistration& registration,
                              const RegistrationOptions& options) {
  make_folder(folder);
  write_both(folder / "registration", registration_figure(pair, registration, options.kernel));
  const StepCurve curve(registration.points_a, registration.points_b, SE3(), options.kernel,
                        options.flow, options.length_scales.front());
  write_both(folder / "step", step_figure(curve));
}

}  // namespace cvo_slam
