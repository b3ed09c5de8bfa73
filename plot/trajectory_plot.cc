// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/plot/trajectory_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/association.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kWidth = 1500;  // [px]

/// A projection along one axis of the world: the directions that point right and up in the panel.
struct Projection {
  const char* title;
  Vector3 right;
  Vector3 up;
};

std::array<Projection, 3> projections_with_z_up() {
  const Vector3 x = Vector3::UnitX();
  const Vector3 y = Vector3::UnitY();
  const Vector3 z = Vector3::UnitZ();
  return {Projection{"Top", x, y}, Projection{"Front", x, z}, Projection{"Side", y, z}};
}

std::array<Projection, 3> projections_of_camera_frame() {
  const Vector3 x = Vector3::UnitX();
  const Vector3 y = Vector3::UnitY();
  const Vector3 z = Vector3::UnitZ();
  return {Projection{"Top", x, z}, Projection{"Front", x, -y}, Projection{"Side", z, -y}};
}

/// Returns the label of an axis along x, y, z or the opposite of one of them; with what is taken
/// off the coordinate if that is not zero: "x - 400000 [m]".
std::string label_of(const Vector3& direction, const Vector3& origin) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const bool is_negative = direction[axis] < 0;
  const char name = "xyz"[axis];
  if (origin[axis] == 0) return fmt::format("{}{} [m]", is_negative ? "-" : "", name);
  const std::string difference =
      fmt::format("{} {} {:.0f}", name, origin[axis] < 0 ? '+' : '-', std::fabs(origin[axis]));
  return is_negative ? fmt::format("-({}) [m]", difference) : difference + " [m]";
}

/// Returns true if the up direction of the world is z, as in motion capture, and not -y, as in the
/// frame of a camera. Most cameras are held upright.
bool is_z_up(const std::vector<StampedPose>& reference) {
  Vector3 up = Vector3::Zero();
  for (const StampedPose& pose : reference) up -= pose.T_world_camera.rotation().col(1);
  return up.z() >= -up.y();
}

void append(Series& series, double x, double y) {
  series.x.push_back(x);
  series.y.push_back(y);
}

template <typename Stamped>
double longest_drawn_step(const std::vector<Stamped>& items) {
  std::vector<Timestamp> stamps;
  stamps.reserve(items.size());
  for (const Stamped& item : items) stamps.push_back(item.stamp);
  return longest_usual_step(stamps);
}

template <typename Stamped>
bool is_gap(const std::vector<Stamped>& items, std::size_t i, double longest_step) {
  return i > 0 && seconds_between(items[i - 1].stamp, items[i].stamp) > longest_step;
}

Series projected(const std::vector<StampedPose>& poses, const Projection& view,
                 const Vector3& origin) {
  const double longest_step = longest_drawn_step(poses);
  Series series;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (is_gap(poses, i, longest_step)) append(series, kNaN, kNaN);
    const Vector3 position = poses[i].T_world_camera.translation() - origin;
    append(series, view.right.dot(position), view.up.dot(position));
  }
  return series;
}

Panel view_panel(const std::vector<StampedPose>& reference,
                 const std::vector<StampedPose>& estimate, const Projection& view,
                 const Vector3& origin) {
  Panel panel{view.title, label_of(view.right, origin), label_of(view.up, origin), {}, true};
  const auto add = [&](Series series, const char* label, Color color, double width) {
    series.label = label;
    series.color = color;
    series.width = width;
    panel.series.push_back(std::move(series));
  };
  // Wide and grey below narrow and blue can be told apart in print too.
  if (!reference.empty()) add(projected(reference, view, origin), "ground truth", kGrey, 3);
  if (estimate.empty()) return panel;
  add(projected(estimate, view, origin), "estimate", kBlue, 1.3);
  add(projected({estimate.front()}, view, origin), "start", kVermilion, 4.5);
  panel.series.back().style = SeriesStyle::kPoints;
  return panel;
}

/// Returns a value of the errors over time, interrupted where several are missing.
template <typename Value>
Series over_time(const std::vector<PoseError>& errors, const Timestamp& origin, Color color,
                 const Value& value) {
  const double longest_step = longest_drawn_step(errors);
  Series series;
  series.color = color;
  series.width = 1.2;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (is_gap(errors, i, longest_step)) append(series, kNaN, kNaN);
    append(series, seconds_between(origin, errors[i].stamp), value(errors[i]));
  }
  return series;
}

Panel error_panel(const std::string& name, const char* quantity, const char* unit, double rmse,
                  Series series) {
  Panel panel;
  panel.title = fmt::format("{} {}, RMSE {:#.4g} {}", name, quantity, rmse, unit);
  panel.x_label = "time [s]";
  panel.y_label = fmt::format("{} [{}]", quantity, unit);
  panel.series = {std::move(series)};
  panel.y_from_zero = true;
  return panel;
}

Vector3 origin_of(const std::vector<StampedPose>& reference,
                  const std::vector<StampedPose>& estimate) {
  const std::vector<StampedPose>& first = reference.empty() ? estimate : reference;
  return first.empty() ? Vector3(Vector3::Zero())
                       : origin_near(first.front().T_world_camera.translation());
}

std::optional<Timestamp> first_stamp(const std::vector<ErrorCurve>& curves) {
  std::optional<Timestamp> first;
  for (const auto& curve : curves) {
    if (!curve.errors.empty() && (!first || curve.errors.front().stamp < *first)) {
      first = curve.errors.front().stamp;
    }
  }
  return first;
}

}  // namespace

Figure trajectory_figure(const std::vector<StampedPose>& reference,
                         const std::vector<StampedPose>& estimate) {
  Figure figure;
  figure.columns = 3;
  figure.width = kWidth;
  figure.height = 560;
  const Vector3 origin = origin_of(reference, estimate);
  const bool z_up = !reference.empty() && is_z_up(reference);
  for (const auto& view : z_up ? projections_with_z_up() : projections_of_camera_frame()) {
    figure.panels.push_back(view_panel(reference, estimate, view, origin));
  }
  return figure;
}

Figure error_figure(const std::vector<ErrorCurve>& curves) {
  constexpr int kRowHeight = 280;
  const int rows = std::clamp(static_cast<int>(curves.size()), 1, 10);
  Figure figure;
  figure.columns = 2;
  figure.width = kWidth;
  figure.height = kRowHeight * rows;
  const Timestamp origin = first_stamp(curves).value_or(Timestamp());
  for (const auto& curve : curves) {
    const auto statistics = summarize(curve.errors);
    figure.panels.push_back(error_panel(
        curve.name, "translation", "mm", statistics.translation.rmse * kMillimetres,
        over_time(curve.errors, origin, kBlue,
                  [](const PoseError& error) { return error.translation * kMillimetres; })));
    figure.panels.push_back(
        error_panel(curve.name, "rotation", "deg", statistics.rotation.rmse * kDegrees,
                    over_time(curve.errors, origin, kVermilion,
                              [](const PoseError& error) { return error.rotation * kDegrees; })));
  }
  return figure;
}

}  // namespace cvo_slam
