// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The only SIMD code of the tracker: Google Highway compiles this file once for each instruction
// set and picks one at run time.
// Vectors are members of structs here, which Arm's scalable vectors cannot be.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cvo_slam/frontend/pair_sums.cc"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "cvo_slam/frontend/pair_sums_internal.h"

HWY_BEFORE_NAMESPACE();
namespace cvo_slam::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using Floats = hn::Vec<FloatTag>;

constexpr FloatTag kTag;

/// exp(x) for x <= 0: 2^n e^r with |r| <= ln(2) / 2 and Taylor's polynomial of degree 6 for e^r,
/// whose relative error is below r^7 / 5040 = 1.2e-7; with rounding, 2.3e-7 was measured. Smaller
/// than e^-80 counts as e^-80.
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
  Constants(const KernelOptions& kernel, double length_scale)
      : sigma2(hn::Set(kTag, static_cast<float>(kernel.sigma * kernel.sigma))),
        threshold(hn::Set(kTag, static_cast<float>(kernel.sparsification))),
        position(hn::Set(kTag, static_cast<float>(-0.5 / (length_scale * length_scale)))),
        color(hn::Set(kTag, static_cast<float>(-0.5 / (kernel.color_scale * kernel.color_scale)))),
        gradient(hn::Set(
            kTag, static_cast<float>(-0.5 / (kernel.gradient_scale * kernel.gradient_scale)))) {}
  Floats sigma2, threshold, position, color, gradient;
};

/// A moving point in the fixed frame and its features, broadcast.
struct MovedPoint {
  MovedPoint(const PointCloud& cloud, std::size_t j, const Vector3& position)
      : x(hn::Set(kTag, static_cast<float>(position.x()))),
        y(hn::Set(kTag, static_cast<float>(position.y()))),
        z(hn::Set(kTag, static_cast<float>(position.z()))),
        f0(hn::Set(kTag, cloud.features[0][j])),
        f1(hn::Set(kTag, cloud.features[1][j])),
        f2(hn::Set(kTag, cloud.features[2][j])),
        f3(hn::Set(kTag, cloud.features[3][j])),
        f4(hn::Set(kTag, cloud.features[4][j])) {}
  Floats x, y, z, f0, f1, f2, f3, f4;
};

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

/// Vector sums of one moving point, a partial sum a lane.
struct Accumulator {
  // Spelled out because the compiler's own constructor would lack the instruction set.
  Accumulator()
      : k(hn::Zero(kTag)),
        w(k),
        excess(w),
        x(w),
        y(w),
        z(w),
        xx(w),
        xy(w),
        xz(w),
        yy(w),
        yz(w),
        zz(w) {}
  Floats k, w, excess, x, y, z, xx, xy, xz, yy, yz, zz;

  [[nodiscard]] PairSums reduce() const {
    const auto sum = [](Floats v) { return hn::GetLane(hn::SumOfLanes(kTag, v)); };
    return {sum(k),
            sum(w),
            sum(excess),
            {sum(x), sum(y), sum(z)},
            {sum(xx), sum(xy), sum(xz), sum(yy), sum(yz), sum(zz)}};
  }
};

template <ColorKernel kColor>
HWY_INLINE void add_run(const Constants& constants, const PointCloud& fixed, const GridRun& run,
                        const MovedPoint& q, Accumulator& sums) {
  for (std::size_t k = run.begin; k < run.end; k += hn::Lanes(kTag)) {
    const Floats rx = hn::Sub(hn::LoadU(kTag, fixed.x.data() + k), q.x);
    const Floats ry = hn::Sub(hn::LoadU(kTag, fixed.y.data() + k), q.y);
    const Floats rz = hn::Sub(hn::LoadU(kTag, fixed.z.data() + k), q.z);
    const Floats d2 = hn::MulAdd(rx, rx, hn::MulAdd(ry, ry, hn::Mul(rz, rz)));
    const Floats value =
        hn::Mul(constants.sigma2, exp_of_negative(hn::Mul(d2, constants.position)));
    const auto inside = hn::And(hn::FirstN(kTag, run.end - k), hn::Gt(value, constants.threshold));
    if (hn::AllFalse(kTag, inside)) continue;
    const Floats c = hn::IfThenElseZero(inside, label_products<kColor>(constants, fixed, k, q));
    const Floats w = hn::Mul(c, value);
    sums.k = hn::Add(sums.k, hn::IfThenElseZero(inside, value));
    sums.w = hn::Add(sums.w, w);
    sums.excess = hn::MulAdd(c, hn::Sub(value, constants.threshold), sums.excess);
    const Floats wx = hn::Mul(w, rx);
    const Floats wy = hn::Mul(w, ry);
    const Floats wz = hn::Mul(w, rz);
    sums.x = hn::Add(sums.x, wx);
    sums.y = hn::Add(sums.y, wy);
    sums.z = hn::Add(sums.z, wz);
    sums.xx = hn::MulAdd(wx, rx, sums.xx);
    sums.xy = hn::MulAdd(wx, ry, sums.xy);
    sums.xz = hn::MulAdd(wx, rz, sums.xz);
    sums.yy = hn::MulAdd(wy, ry, sums.yy);
    sums.yz = hn::MulAdd(wy, rz, sums.yz);
    sums.zz = hn::MulAdd(wz, rz, sums.zz);
  }
}

template <ColorKernel kColor>
void sum_all(const NeighborGrid& grid, const PointCloud& moving, const SE3& T_fixed_moving,
             const Constants& constants, std::size_t begin, std::size_t end, PairSums* sums) {
  std::array<GridRun, NeighborGrid::kMaxRuns> runs{};
  for (std::size_t j = begin; j < end; ++j) {
    const Vector3 position = T_fixed_moving * moving.position(j);
    const std::size_t count =
        grid.query(static_cast<float>(position.x()), static_cast<float>(position.y()),
                   static_cast<float>(position.z()), runs);
    if (count == 0) {
      sums[j - begin] = PairSums();
      continue;
    }
    const MovedPoint q(moving, j, position);
    Accumulator accumulator;
    for (std::size_t i = 0; i < count; ++i) {
      add_run<kColor>(constants, grid.points(), runs[i], q, accumulator);
    }
    sums[j - begin] = accumulator.reduce();
  }
}

void sum_pairs(const NeighborGrid& grid, const PointCloud& moving, const SE3& T_fixed_moving,
               const KernelOptions& kernel, double length_scale, std::size_t begin, std::size_t end,
               PairSums* sums) {
  const Constants constants(kernel, length_scale);
  const auto sum = kernel.color_kernel == ColorKernel::kLinear
                       ? sum_all<ColorKernel::kLinear>
                       : sum_all<ColorKernel::kSquaredExponential>;
  sum(grid, moving, T_fixed_moving, constants, begin, end, sums);
}

void simd_exp(std::span<const float> x, std::span<float> y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    y[i] = hn::GetLane(exp_of_negative(hn::Set(kTag, x[i])));
  }
}

}  // namespace
}  // namespace cvo_slam::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cvo_slam {

HWY_EXPORT(sum_pairs);
HWY_EXPORT(simd_exp);

void sum_pairs(const NeighborGrid& grid, const PointCloud& moving, const SE3& T_fixed_moving,
               const KernelOptions& kernel, double length_scale, std::size_t begin, std::size_t end,
               PairSums* sums) {
  HWY_DYNAMIC_DISPATCH(sum_pairs)
  (grid, moving, T_fixed_moving, kernel, length_scale, begin, end, sums);
}

std::vector<float> simd_exp(std::span<const float> x) {
  std::vector<float> y(x.size());
  HWY_DYNAMIC_DISPATCH(simd_exp)(x, y);
  return y;
}

}  // namespace cvo_slam
#endif
