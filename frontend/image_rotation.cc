// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/frontend/image_rotation_internal.h"

namespace cvo_slam {
namespace {

constexpr int kLongerSide = 40;  // [px]
/// Least share of the pixels of one image that must be in the other one.
constexpr double kLeastOverlap = 0.3;

cv::Mat tiny_image(const cv::Mat& color, const cv::Size& size) {
  cv::Mat small;
  cv::resize(color, small, size, 0, 0, cv::INTER_AREA);
  cv::Mat grey = small;
  if (small.channels() == 3) cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
  cv::Mat tiny;
  grey.convertTo(tiny, CV_32F);
  cv::GaussianBlur(tiny, tiny, {}, 1.0);
  return tiny;
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

/// Sums over the pixels that two images have in common. Their means there and their contrasts are
/// taken out, so that a change of exposure changes nothing.
struct Comparison {
  int count = 0;
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;

  void add(double of_a, double of_b) {
    ++count;
    a += of_a;
    b += of_b;
    aa += of_a * of_a;
    bb += of_b * of_b;
    ab += of_a * of_b;
  }
  [[nodiscard]] double squares_of_a() const { return aa - a * a / count; }
  [[nodiscard]] double squares_of_b() const { return bb - b * b / count; }
  /// 0 where the images have too little in common, or nothing to compare.
  [[nodiscard]] double correlation(std::size_t pixels) const {
    constexpr double kLeastVariance = 1;  // [squared 8-bit values]
    if (count < kLeastOverlap * static_cast<double>(pixels)) return 0;
    if (std::min(squares_of_a(), squares_of_b()) < kLeastVariance * count) return 0;
    return (ab - a * b / count) / std::sqrt(squares_of_a() * squares_of_b());
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

/// The images compared at a rotation R, with the sums of Gauss-Newton for a turn by a small w,
/// R <- exp(w) R.
struct Linearised {
  Comparison comparison;
  Vector3 j = Vector3::Zero(), ja = Vector3::Zero(), jb = Vector3::Zero();
  Matrix3 jj = Matrix3::Zero();

  void add(const Vector3& jacobian, double a, double b) {
    comparison.add(a, b);
    j += jacobian;
    ja += jacobian * a;
    jb += jacobian * b;
    jj += jacobian * jacobian.transpose();
  }
  /// The w that brings a, without its mean, nearest to b, scaled to the contrast of a.
  [[nodiscard]] Vector3 step() const {
    constexpr double kDamping = 1e-4;
    const int n = comparison.count;
    const double contrast = std::sqrt(comparison.squares_of_a() / comparison.squares_of_b());
    Matrix3 hessian = jj - j * j.transpose() / n;
    hessian += kDamping * hessian.trace() * Matrix3::Identity();  // keeps what is not seen as it is
    const Vector3 gradient = ja - j * comparison.a / n - contrast * (jb - j * comparison.b / n);
    return -hessian.ldlt().solve(gradient);
  }
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
      const double gx = s.dx * camera.fx / q.z();
      const double gy = s.dy * camera.fy / q.z();
      const Vector3 by_q(gx, gy, -(gx * q.x() + gy * q.y()) / q.z());
      sums.add(q.cross(by_q), s.value, row[x]);
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
    if (at.comparison.correlation(to.total()) == 0) return {R, 0};
    const Vector3 w = at.step();
    R = so3_exp(w) * R;
    if (w.norm() < kConverged) break;
  }
  return {R, linearise(from, to, camera, R).comparison.correlation(to.total())};
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
  return sums.correlation(to.total());
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
  const int longer = std::max(camera.width, camera.height);
  const cv::Size size(std::max(2, kLongerSide * camera.width / longer),
                      std::max(2, kLongerSide * camera.height / longer));
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
