// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/frontend/image_rotation_internal.h"

namespace cvo_slam {
namespace {

constexpr int kWidth = 40;  // [px]
/// Least share of the pixels of one image that must be in the other one.
constexpr double kLeastOverlap = 0.3;

/// A tiny grey image with the mean 0 and the standard deviation 1, so that a change of exposure
/// changes nothing.
cv::Mat tiny_image(const cv::Mat& color, const cv::Size& size) {
  cv::Mat small;
  cv::resize(color, small, size, 0, 0, cv::INTER_AREA);
  cv::Mat grey = small;
  if (small.channels() == 3) cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
  cv::Mat tiny;
  grey.convertTo(tiny, CV_32F);
  cv::GaussianBlur(tiny, tiny, {}, 1.0);
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(tiny, mean, deviation);
  return (tiny - mean[0]) / std::max(deviation[0], 1.0);
}

/// The camera of an image of that size with the same field of view.
PinholeCamera scaled(const PinholeCamera& camera, const cv::Size& size) {
  const double x = static_cast<double>(size.width) / camera.width;
  const double y = static_cast<double>(size.height) / camera.height;
  PinholeCamera tiny;
  tiny.width = size.width;
  tiny.height = size.height;
  tiny.fx = camera.fx * x;
  tiny.fy = camera.fy * y;
  tiny.cx = (camera.cx + 0.5) * x - 0.5;
  tiny.cy = (camera.cy + 0.5) * y - 0.5;
  return tiny;
}

/// Sums over the pixels that two images have in common.
struct Comparison {
  int count = 0;
  double aa = 0, bb = 0, ab = 0;

  void add(double a, double b) {
    ++count;
    aa += a * a;
    bb += b * b;
    ab += a * b;
  }
  /// 0 where the images have too little in common.
  [[nodiscard]] double correlation(double pixels) const {
    if (count < kLeastOverlap * pixels || aa <= 0 || bb <= 0) return 0;
    return ab / std::sqrt(aa * bb);
  }
};

/// The value of an image between four pixels, and how it changes along the rows and columns.
struct Sample {
  double value, dx, dy;
};

Sample sample(const cv::Mat& image, double u, double v) {
  const int x = static_cast<int>(u);
  const int y = static_cast<int>(v);
  const double a = u - x;
  const double b = v - y;
  const auto* above = image.ptr<float>(y) + x;
  const auto* below = image.ptr<float>(y + 1) + x;
  const double top = above[1] - above[0];
  const double bottom = below[1] - below[0];
  const double left = below[0] - above[0];
  const double right = below[1] - above[1];
  return {above[0] + a * top + b * left + a * b * (bottom - top), top + b * (bottom - top),
          left + a * (right - left)};
}

/// A step of Gauss-Newton: the images are compared at a rotation, with the normal equations of a
/// turn by a small w, R <- exp(w) R.
struct Linearised {
  Comparison comparison;
  Matrix3 hessian = Matrix3::Zero();
  Vector3 gradient = Vector3::Zero();
};

Linearised linearise(const cv::Mat& from, const cv::Mat& to, const PinholeCamera& camera,
                     const Matrix3& R) {
  Linearised sums;
  for (int y = 0; y < to.rows; ++y) {
    const auto* const row = to.ptr<float>(y);
    for (int x = 0; x < to.cols; ++x) {
      // q = R K^-1 (x, y, 1); dq = w x q
      const Vector3 q = R * Vector3((x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, 1);
      if (q.z() <= 0.1) continue;
      const double u = camera.fx * q.x() / q.z() + camera.cx;
      const double v = camera.fy * q.y() / q.z() + camera.cy;
      if (u < 0 || v < 0 || u >= from.cols - 1 || v >= from.rows - 1) continue;
      const Sample s = sample(from, u, v);
      sums.comparison.add(s.value, row[x]);
      const double gx = s.dx * camera.fx / q.z();
      const double gy = s.dy * camera.fy / q.z();
      const Vector3 by_q(gx, gy, -(gx * q.x() + gy * q.y()) / q.z());
      const Vector3 jacobian = q.cross(by_q);
      sums.hessian += jacobian * jacobian.transpose();
      sums.gradient += jacobian * (s.value - row[x]);
    }
  }
  return sums;
}

ImageRotation refined(const cv::Mat& from, const cv::Mat& to, const PinholeCamera& camera,
                      const Matrix3& R_start) {
  constexpr int kSteps = 10;
  constexpr double kConverged = 1e-4;  // [rad]
  Matrix3 R = R_start;
  for (int i = 0; i < kSteps; ++i) {
    const Linearised at = linearise(from, to, camera, R);
    if (at.comparison.correlation(static_cast<double>(to.total())) <= 0) return {R, 0};
    const Vector3 w = -(at.hessian + 1e-9 * Matrix3::Identity()).ldlt().solve(at.gradient);
    R = so3_exp(w) * R;
    if (w.norm() < kConverged) break;
  }
  return {R,
          linearise(from, to, camera, R).comparison.correlation(static_cast<double>(to.total()))};
}

/// The correlation if what is at (x, y) in `to` is at (x + dx, y + dy) in `from`.
double correlation_of_shift(const cv::Mat& from, const cv::Mat& to, int dx, int dy) {
  Comparison sums;
  for (int y = std::max(0, -dy); y < std::min(to.rows, to.rows - dy); ++y) {
    const auto* const a = from.ptr<float>(y + dy);
    const auto* const b = to.ptr<float>(y);
    for (int x = std::max(0, -dx); x < std::min(to.cols, to.cols - dx); ++x) {
      sums.add(a[x + dx], b[x]);
    }
  }
  return sums.correlation(static_cast<double>(to.total()));
}

/// The turn about the camera's x and y axes that shifts the middle of the image.
Matrix3 rotation_of_best_shift(const cv::Mat& from, const cv::Mat& to,
                               const PinholeCamera& camera) {
  cv::Mat a;
  cv::Mat b;
  const cv::Size half(from.cols / 2, from.rows / 2);
  cv::resize(from, a, half, 0, 0, cv::INTER_AREA);
  cv::resize(to, b, half, 0, 0, cv::INTER_AREA);
  double best = 0;
  cv::Point shift;
  for (int dy = -half.height / 2; dy <= half.height / 2; ++dy) {
    for (int dx = -half.width / 2; dx <= half.width / 2; ++dx) {
      const double correlation = correlation_of_shift(a, b, dx, dy);
      if (correlation <= best) continue;
      best = correlation;
      shift = {dx, dy};
    }
  }
  const Vector3 ahead(2 * shift.x / camera.fx, 2 * shift.y / camera.fy, 1);
  return Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), ahead).toRotationMatrix();
}

}  // namespace

ImageRotation find_image_rotation(const cv::Mat& from, const cv::Mat& to,
                                  const PinholeCamera& camera, const Matrix3& R_start) {
  const cv::Size size(kWidth, std::max(2, kWidth * camera.height / camera.width));
  const PinholeCamera tiny = scaled(camera, size);
  const cv::Mat a = tiny_image(from, size);
  const cv::Mat b = tiny_image(to, size);
  const ImageRotation from_start = refined(a, b, tiny, R_start);
  const ImageRotation from_shift = refined(a, b, tiny, rotation_of_best_shift(a, b, tiny));
  return from_start.correlation >= from_shift.correlation ? from_start : from_shift;
}

SE3 turned_as_seen(const SE3& T_from_to, const cv::Mat& from, const cv::Mat& to,
                   const PinholeCamera& camera) {
  constexpr double kLeastCorrelation = 0.7;
  const ImageRotation turn = find_image_rotation(from, to, camera, T_from_to.rotation());
  if (turn.correlation < kLeastCorrelation) return T_from_to;
  return SE3(turn.R_from_to, T_from_to.translation());
}

}  // namespace cvo_slam
