// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vector types of pair_sums.cc: floats, the kernel, points, sums. This file is compiled once for
// each instruction set, hence Highway's guard in place of a #pragma once.
#if defined(CVO_SLAM_FRONTEND_SIMD_INTERNAL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CVO_SLAM_FRONTEND_SIMD_INTERNAL_H
#undef CVO_SLAM_FRONTEND_SIMD_INTERNAL_H
#else
#define CVO_SLAM_FRONTEND_SIMD_INTERNAL_H
#endif

#include <array>
#include <cstddef>

#include <hwy/highway.h>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/registration.h"

HWY_BEFORE_NAMESPACE();
namespace cvo_slam::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using Floats = hn::Vec<FloatTag>;

constexpr FloatTag kTag;

HWY_INLINE Floats broadcast(double value) { return hn::Set(kTag, static_cast<float>(value)); }

/// Returns exp(x) for x <= 0 as 2^n e^r with |r| <= ln(2) / 2 and Taylor's polynomial of degree 6
/// for e^r, whose relative error is below r^7 / 5040 = 1.2e-7; with rounding, 2.3e-7 was measured.
/// The result is never less than e^-80.
HWY_INLINE Floats exp_of_negative(Floats x) {
  constexpr float kSmallest = -80.0F;
  constexpr float kLog2E = 1.44269504F;
  constexpr float kLn2High = 0.693359375F;  // few bits: n kLn2High is exact
  constexpr float kLn2Low = -2.12194440e-4F;
  x = hn::Max(x, hn::Set(kTag, kSmallest));
  const Floats n = hn::Round(hn::Mul(x, hn::Set(kTag, kLog2E)));
  Floats r = hn::NegMulAdd(n, hn::Set(kTag, kLn2High), x);
  r = hn::NegMulAdd(n, hn::Set(kTag, kLn2Low), r);
  Floats p = hn::Set(kTag, 1.0F / 720);
  for (const float c : {1.0F / 120, 1.0F / 24, 1.0F / 6, 0.5F, 1.0F, 1.0F}) {
    p = hn::MulAdd(p, r, hn::Set(kTag, c));
  }
  const hn::RebindToSigned<FloatTag> int_tag;
  const auto exponent = hn::Add(hn::ConvertTo(int_tag, n), hn::Set(int_tag, 127));
  return hn::Mul(p, hn::BitCast(kTag, hn::ShiftLeft<23>(exponent)));
}

/// The kernel's constants, broadcast once.
struct Constants {
  explicit Constants(const KernelOptions& kernel, double length_scale = 1)
      : sigma2(broadcast(kernel.sigma * kernel.sigma)),
        threshold(broadcast(kernel.sparsification)),
        position(broadcast(-0.5 / (length_scale * length_scale))),
        color(broadcast(-0.5 / (kernel.color_scale * kernel.color_scale))),
        gradient(broadcast(-0.5 / (kernel.gradient_scale * kernel.gradient_scale))) {}
  Floats sigma2, threshold, position, color, gradient;

  [[nodiscard]] HWY_INLINE Floats k(Floats squared_distance) const {
    return hn::Mul(sigma2, exp_of_negative(hn::Mul(squared_distance, position)));
  }
};

struct Point {
  Floats x, y, z;
};

HWY_INLINE Point operator-(const Point& a, const Point& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE Point operator+(const Point& a, const Point& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

HWY_INLINE Floats dot(const Point& a, const Point& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

HWY_INLINE Point cross(const Point& a, const Point& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}

/// A rigid motion in single precision.
class Motion {
 public:
  explicit Motion(const SE3& T) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      for (std::size_t j = 0; j < 3; ++j) {
        R_[3 * i + j] = static_cast<float>(T.rotation()(row, static_cast<Eigen::Index>(j)));
      }
      t_[i] = static_cast<float>(T.translation()[row]);
    }
  }
  [[nodiscard]] HWY_INLINE Point operator*(const Point& p) const {
    return {row(0, p), row(1, p), row(2, p)};
  }

 private:
  [[nodiscard]] HWY_INLINE Floats row(std::size_t i, const Point& p) const {
    const auto at = [&](std::size_t j) { return hn::Set(kTag, R_[3 * i + j]); };
    return hn::MulAdd(at(0), p.x,
                      hn::MulAdd(at(1), p.y, hn::MulAdd(at(2), p.z, hn::Set(kTag, t_[i]))));
  }

  std::array<float, 9> R_;
  std::array<float, 3> t_;
};

/// A moving point's position in the fixed frame and its labels, broadcast.
struct MovedPoint {
  MovedPoint(const PointCloud& cloud, std::size_t j, const Vector3& position)
      : q{broadcast(position.x()), broadcast(position.y()), broadcast(position.z())},
        f0(hn::Set(kTag, cloud.features[0][j])),
        f1(hn::Set(kTag, cloud.features[1][j])),
        f2(hn::Set(kTag, cloud.features[2][j])),
        f3(hn::Set(kTag, cloud.features[3][j])),
        f4(hn::Set(kTag, cloud.features[4][j])) {}
  Point q;
  Floats f0, f1, f2, f3, f4;
};

HWY_INLINE Point load_position(const PointCloud& cloud, std::size_t k) {
  return {hn::LoadU(kTag, cloud.x.data() + k), hn::LoadU(kTag, cloud.y.data() + k),
          hn::LoadU(kTag, cloud.z.data() + k)};
}

template <ColorKernel kColor>
HWY_INLINE Floats label_products(const Constants& constants, const PointCloud& fixed, std::size_t k,
                                 const MovedPoint& q) {
  const auto load = [&](std::size_t f) { return hn::LoadU(kTag, fixed.features[f].data() + k); };
  if constexpr (kColor == ColorKernel::kLinear) {
    const Floats product =
        hn::MulAdd(load(0), q.f0, hn::MulAdd(load(1), q.f1, hn::Mul(load(2), q.f2)));
    return hn::Mul(product, hn::Set(kTag, 1e-5F));
  } else {
    const Floats d0 = hn::Sub(load(0), q.f0);
    const Floats d1 = hn::Sub(load(1), q.f1);
    const Floats d2 = hn::Sub(load(2), q.f2);
    const Floats d3 = hn::Sub(load(3), q.f3);
    const Floats d4 = hn::Sub(load(4), q.f4);
    const Floats color = hn::MulAdd(d0, d0, hn::MulAdd(d1, d1, hn::Mul(d2, d2)));
    const Floats gradient = hn::MulAdd(d3, d3, hn::Mul(d4, d4));
    return exp_of_negative(
        hn::MulAdd(color, constants.color, hn::Mul(gradient, constants.gradient)));
  }
}

/// Double precision sums of single precision lanes.
template <std::size_t kCount>
class Totals {
 public:
  HWY_INLINE void add(Floats v) {
    HWY_ALIGN std::array<float, HWY_MAX_BYTES / sizeof(float)> lanes;
    hn::Store(v, kTag, lanes.data());
    double* const sum = sums_.data() + kDoubles * next_++;
    auto total = hn::Load(kDoubleTag, sum);
    for (std::size_t i = 0; i < hn::Lanes(kTag); i += hn::Lanes(kDoubleTag)) {
      total = hn::Add(total, hn::PromoteTo(kDoubleTag, hn::Load(kHalfTag, lanes.data() + i)));
    }
    hn::Store(total, kDoubleTag, sum);
  }
  HWY_INLINE void add(const Point& p) {
    add(p.x);
    add(p.y);
    add(p.z);
  }
  void rewind() { next_ = 0; }

  [[nodiscard]] std::array<double, kCount> reduce() const {
    std::array<double, kCount> sums{};
    for (std::size_t i = 0; i < kCount; ++i) {
      for (std::size_t lane = 0; lane < hn::Lanes(kDoubleTag); ++lane) {
        sums[i] += sums_[kDoubles * i + lane];
      }
    }
    return sums;
  }

 private:
  using DoubleTag = hn::ScalableTag<double>;
  static constexpr DoubleTag kDoubleTag{};
  static constexpr hn::Rebind<float, DoubleTag> kHalfTag{};
  static constexpr std::size_t kDoubles = HWY_MAX_BYTES / sizeof(double);

  HWY_ALIGN std::array<double, kCount * kDoubles> sums_{};
  std::size_t next_ = 0;
};

}  // namespace
}  // namespace cvo_slam::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
