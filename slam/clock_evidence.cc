// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/slam/clock_evidence_internal.h"

namespace cvo_slam {
namespace {

/// Normal equations of residuals in a left perturbation of T_fixed_moving.
struct NormalEquations {
  Matrix6 H = Matrix6::Zero();
  Vector6 g = Vector6::Zero();
  std::size_t count = 0;

  void add(const Vector6& jacobian, double residual, double weight) {
    H += weight * jacobian * jacobian.transpose();
    g += weight * residual * jacobian;
    ++count;
  }
};

/// The weight of a residual by Huber's loss, in units of its standard deviation.
double huber_weight(double residual, double sigma) {
  constexpr double kLimit = 1.5;
  const double size = std::fabs(residual) / sigma;
  return (size < kLimit ? 1 : kLimit / size) / (sigma * sigma);
}

PinholeCamera half(PinholeCamera camera) {
  // Pixel (0, 0) of the half image is the centre of the first four.
  camera.cx = 0.5 * (camera.cx - 0.5);
  camera.cy = 0.5 * (camera.cy - 0.5);
  camera.fx *= 0.5;
  camera.fy *= 0.5;
  camera.width /= 2;
  camera.height /= 2;
  return camera;
}

double at(const cv::Mat& image, const Eigen::Vector2d& pixel) {
  const int u = static_cast<int>(pixel.x());
  const int v = static_cast<int>(pixel.y());
  const double a = pixel.x() - u;
  const double b = pixel.y() - v;
  const std::uint8_t* upper = image.ptr<std::uint8_t>(v) + u;
  const std::uint8_t* lower = image.ptr<std::uint8_t>(v + 1) + u;
  return (1 - b) * ((1 - a) * upper[0] + a * upper[1]) + b * ((1 - a) * lower[0] + a * lower[1]);
}

/// Two frames, and the geometry that their comparison needs.
class Pair {
 public:
  Pair(const ClockFrame& fixed, const ClockFrame& moving, const ClockCamera& camera)
      : fixed_(fixed),
        moving_(moving),
        camera_(camera),
        pinhole_(camera.pinhole()),
        T_fixed_moving_(fixed.T_world_camera.inverse() * moving.T_world_camera) {}

  [[nodiscard]] std::optional<ClockEvidence> evidence() {
    constexpr int kIterations = 3;
    constexpr std::size_t kLeastPoints = 200;
    match_brightness();
    for (int i = 0; i < kIterations; ++i) {
      linearise();
      if (color_.count < kLeastPoints || depth_.count < kLeastPoints) return std::nullopt;
      const Matrix6 H = color_.H + depth_.H;
      T_fixed_moving_ = SE3::exp(-H.ldlt().solve(color_.g + depth_.g)) * T_fixed_moving_;
    }
    linearise();
    // A change x of the delay moves the points of depth by x a. The pose is eliminated.
    const Vector6 a = T_fixed_moving_.adjoint() * moving_.velocity - fixed_.velocity;
    const Vector6 Ha = depth_.H * a;
    const Eigen::LDLT<Matrix6> joint(color_.H + depth_.H);
    const Vector6 eliminated = joint.solve(Ha);
    return ClockEvidence{a.dot(Ha) - Ha.dot(eliminated),
                         a.dot(depth_.g) - eliminated.dot(color_.g + depth_.g)};
  }

 private:
  static constexpr int kStep = 3;   // distance of the points that are compared [px]
  static constexpr int kReach = 3;  // of the neighbours that give a normal [px]

  /// The movement of a point in a time, to first order, in the frame of the camera that moves:
  /// where the camera at the stamp sees what it saw `seconds` later.
  static Vector3 moved(const Vector3& point, const Vector6& velocity, double seconds) {
    return point + seconds * (velocity.head<3>() + velocity.tail<3>().cross(point));
  }

  [[nodiscard]] bool is_inside(const Eigen::Vector2d& pixel) const {
    constexpr double kBorder = kReach + 1;
    return pixel.x() > kBorder && pixel.y() > kBorder && pixel.x() < pinhole_.width - 1 - kBorder &&
           pixel.y() < pinhole_.height - 1 - kBorder;
  }

  /// Returns the pixel at which the fixed frame saw a point (in its frame at the stamp) with rows
  /// that were read at their time, and images that were taken `delay` after the stamp.
  [[nodiscard]] std::optional<Eigen::Vector2d> seen_at(const Vector3& point, double delay,
                                                       Vector3& then) const {
    then = moved(point, fixed_.velocity, -delay);
    for (int i = 0; i < 2; ++i) {
      if (then.z() < 0.1) return std::nullopt;
      const Eigen::Vector2d pixel = pinhole_.project(then);
      if (!is_inside(pixel)) return std::nullopt;
      if (!camera_.has_rolling_shutter()) return pixel;
      then = moved(point, fixed_.velocity, -delay - camera_.row_delay(pixel.y()));
    }
    if (then.z() < 0.1) return std::nullopt;
    const Eigen::Vector2d pixel = pinhole_.project(then);
    return is_inside(pixel) ? std::optional(pixel) : std::nullopt;
  }

  void linearise() {
    color_ = {};
    depth_ = {};
    for (int v = kReach + 1; v < pinhole_.height - kReach - 1; v += kStep) {
      const auto* greys = moving_.grey.ptr<std::uint8_t>(v);
      for (int u = kReach + 1; u < pinhole_.width - kReach - 1; u += kStep) {
        const double z = camera_.depth_at(moving_.depth, u, v);
        if (z == 0) continue;
        const Vector3 point = z * camera_.ray(u, v);
        add_color(moved(point, moving_.velocity, camera_.row_delay(v)), greys[u]);
        add_depth(moved(point, moving_.velocity, moving_.delay + camera_.row_delay(v)));
      }
    }
  }

  void add_color(const Vector3& point, double grey) {
    const Vector3 q = T_fixed_moving_ * point;
    Vector3 then;
    const auto pixel = seen_at(q, 0, then);
    if (!pixel) return;
    const Eigen::Vector2d dx(1, 0);
    const Eigen::Vector2d dy(0, 1);
    const Eigen::Vector2d slope(
        0.5 * (at(fixed_.grey, *pixel + dx) - at(fixed_.grey, *pixel - dx)),
        0.5 * (at(fixed_.grey, *pixel + dy) - at(fixed_.grey, *pixel - dy)));
    const double residual = at(fixed_.grey, *pixel) - gain_ * grey - offset_;
    if (std::fabs(residual) > 60) return;
    const double fx = pinhole_.fx / then.z();
    const double fy = pinhole_.fy / then.z();
    const Vector3 row(slope.x() * fx, slope.y() * fy,
                      -(slope.x() * fx * then.x() + slope.y() * fy * then.y()) / then.z());
    Vector6 jacobian;
    jacobian << row, q.cross(row);
    color_.add(jacobian, residual, huber_weight(residual, 8));
  }

  void add_depth(const Vector3& point) {
    const Vector3 q = T_fixed_moving_ * point;
    Vector3 then;
    const auto pixel = seen_at(q, fixed_.delay, then);
    if (!pixel) return;
    const int u = static_cast<int>(std::lround(pixel->x()));
    const int v = static_cast<int>(std::lround(pixel->y()));
    const double z = camera_.depth_at(fixed_.depth, u, v);
    const auto normal = normal_at(u, v, z);
    if (!normal) return;
    const double residual = normal->dot(then - z * camera_.ray(u, v));
    if (std::fabs(residual) > 0.05 * z) return;
    Vector6 jacobian;
    jacobian << *normal, q.cross(*normal);
    depth_.add(jacobian, residual, huber_weight(residual, 1.5 * camera_.noise().sigma_z(z)));
  }

  /// Returns the normal of the fixed frame's surface; empty at an edge.
  [[nodiscard]] std::optional<Vector3> normal_at(int u, int v, double z) const {
    constexpr double kLargestStep = 0.04;  // of the depth
    if (!(z > 0)) return std::nullopt;
    const auto neighbour = [&](int du, int dv, Vector3& point) {
      const double depth = camera_.depth_at(fixed_.depth, u + du, v + dv);
      point = depth * camera_.ray(u + du, v + dv);
      return std::fabs(depth - z) < kLargestStep * z;
    };
    Vector3 left;
    Vector3 right;
    Vector3 up;
    Vector3 down;
    if (!neighbour(-kReach, 0, left) || !neighbour(kReach, 0, right) ||
        !neighbour(0, -kReach, up) || !neighbour(0, kReach, down)) {
      return std::nullopt;
    }
    return (right - left).cross(down - up).normalized();
  }

  /// Finds the affine change of brightness between the two images.
  void match_brightness() {
    cv::Scalar mean_fixed;
    cv::Scalar mean_moving;
    cv::Scalar deviation_fixed;
    cv::Scalar deviation_moving;
    cv::meanStdDev(fixed_.grey, mean_fixed, deviation_fixed);
    cv::meanStdDev(moving_.grey, mean_moving, deviation_moving);
    constexpr double kLeast = 1;  // [grey levels]
    gain_ = std::max(deviation_fixed[0], kLeast) / std::max(deviation_moving[0], kLeast);
    offset_ = mean_fixed[0] - gain_ * mean_moving[0];
  }

  const ClockFrame& fixed_;
  const ClockFrame& moving_;
  const ClockCamera& camera_;
  const PinholeCamera& pinhole_;
  SE3 T_fixed_moving_;
  double gain_ = 1;
  double offset_ = 0;
  NormalEquations color_;
  NormalEquations depth_;
};

}  // namespace

ClockCamera::ClockCamera(const Camera& camera)
    : pinhole_(half(camera.color)),
      noise_(camera.noise),
      metres_(1 / camera.depth_scale),
      row_time_(camera.readout_time / pinhole_.height) {
  for (int v = 0; v < pinhole_.height; ++v) {
    for (int u = 0; u < pinhole_.width; ++u) {
      rays_.push_back(pinhole_.unproject(Eigen::Vector2d(u, v)));
    }
  }
}

ClockFrame make_clock_frame(const RgbdFrame& frame) {
  ClockFrame result;
  cv::Mat grey = frame.color;
  if (grey.channels() == 3) cv::cvtColor(frame.color, grey, cv::COLOR_BGR2GRAY);
  const cv::Size size(grey.cols / 2, grey.rows / 2);
  cv::resize(grey, grey, size, 0, 0, cv::INTER_AREA);
  cv::GaussianBlur(grey, result.grey, {3, 3}, 0);
  // Depths are never averaged: an edge has none between.
  cv::resize(frame.depth, result.depth, size, 0, 0, cv::INTER_NEAREST);
  return result;
}

std::optional<ClockEvidence> clock_evidence(const ClockFrame& fixed, const ClockFrame& moving,
                                            const ClockCamera& camera) {
  return Pair(fixed, moving, camera).evidence();
}

}  // namespace cvo_slam
