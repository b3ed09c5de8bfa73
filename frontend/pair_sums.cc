// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The SIMD code of the tracker, with neighbor_search.cc: Google Highway compiles these files once
// for each instruction set and picks one at run time. Vectors are members of structs here, which
// Arm's scalable vectors cannot be.
#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_AVX3_DL)
// The scalar path too, and not every step between.
#define HWY_COMPILE_ALL_ATTAINABLE
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cvo_slam/frontend/pair_sums.cc"
#include <bit>

#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "cvo_slam/frontend/pair_sums_internal.h"
#include "cvo_slam/frontend/simd_internal.h"

HWY_BEFORE_NAMESPACE();
namespace cvo_slam::HWY_NAMESPACE {
namespace {

using PairTotals = Totals<sizeof(PairSums) / sizeof(double)>;

/// Columns (or rows) of a symmetric matrix.
struct Symmetric {
  Point x, y, z;
};

/// The sums of several moving points, one a lane.
struct LaneSums {
  Floats matched, value, w;
  Point p;       ///< sum w p
  Symmetric pp;  ///< sum w p p^T
};

/// Loads the positions of a row or group from a lane on.
template <typename Positions>
HWY_INLINE Point load(const Positions& from, std::size_t lane) {
  return {hn::Load(kTag, from.x.data() + lane), hn::Load(kTag, from.y.data() + lane),
          hn::Load(kTag, from.z.data() + lane)};
}

template <bool kShaped>
HWY_INLINE LaneSums sum_rows(const Constants& constants, const PairTable::Row* begin,
                             const PairTable::Row* end, std::size_t lane, const Point& q,
                             const Symmetric& P) {
  const Floats zero = hn::Zero(kTag);
  const Floats one = hn::Set(kTag, 1.0F);
  Floats matched = zero;
  Floats value = zero;
  Floats w_sum = zero;
  Floats x = zero;
  Floats y = zero;
  Floats z = zero;
  Floats xx = zero;
  Floats xy = zero;
  Floats xz = zero;
  Floats yy = zero;
  Floats yz = zero;
  Floats zz = zero;
  for (const PairTable::Row* row = begin; row != end; ++row) {
    const Point r = load(*row, lane) - q;
    Point p = r;
    if constexpr (kShaped) p = {dot(P.x, r), dot(P.y, r), dot(P.z, r)};
    const Floats k = constants.k(dot(r, p));
    const auto inside = hn::Gt(k, constants.threshold);
    const Floats c = hn::IfThenElseZero(inside, hn::Load(kTag, row->c.data() + lane));
    matched = hn::IfThenElse(inside, one, matched);
    value = hn::MulAdd(c, hn::Sub(k, constants.threshold), value);
    const Floats w = hn::Mul(c, k);
    w_sum = hn::Add(w_sum, w);
    const Floats wx = hn::Mul(w, p.x);
    const Floats wy = hn::Mul(w, p.y);
    const Floats wz = hn::Mul(w, p.z);
    x = hn::Add(x, wx);
    y = hn::Add(y, wy);
    z = hn::Add(z, wz);
    xx = hn::MulAdd(wx, p.x, xx);
    xy = hn::MulAdd(wx, p.y, xy);
    xz = hn::MulAdd(wx, p.z, xz);
    yy = hn::MulAdd(wy, p.y, yy);
    yz = hn::MulAdd(wy, p.z, yz);
    zz = hn::MulAdd(wz, p.z, zz);
  }
  return {matched, value, w_sum, {x, y, z}, {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
}

/// Adds a symmetric matrix M of each point, M q^ by columns, and -q^ M q^.
HWY_INLINE void add_quadratic(const Symmetric& m, const Point& q, PairTotals& totals) {
  // Row a of M q^ is a x q; column b of -q^ (M q^) is -(q x column b).
  const Point rx = cross(m.x, q);
  const Point ry = cross(m.y, q);
  const Point rz = cross(m.z, q);
  const Point bx{rx.x, ry.x, rz.x};
  const Point by{rx.y, ry.y, rz.y};
  const Point bz{rx.z, ry.z, rz.z};
  const Point qx = cross(bx, q);
  const Point qy = cross(by, q);
  const Point qz = cross(bz, q);
  totals.add(m.x);
  totals.add(m.y.y);
  totals.add(m.y.z);
  totals.add(m.z.z);
  totals.add(bx);
  totals.add(by);
  totals.add(bz);
  totals.add(qx);
  totals.add(qy.y);
  totals.add(qy.z);
  totals.add(qz.z);
}

/// Adds the moving points of a vector to the totals, in the order of PairSums.
HWY_INLINE void add_points(const LaneSums& sums, const Point& q, const Symmetric& P, Floats inv2,
                           PairTotals& totals) {
  const auto scaled = [](const Point& p, Floats f) HWY_ATTR {
    return Point{hn::Mul(p.x, f), hn::Mul(p.y, f), hn::Mul(p.z, f)};
  };
  const Floats inv4 = hn::Mul(inv2, inv2);
  const Floats w = hn::Mul(sums.w, inv2);
  const Point s = scaled(sums.p, inv2);
  const Symmetric b{scaled(P.x, w), scaled(P.y, w), scaled(P.z, w)};
  const auto less = [&](const Point& from, const Point& pp) HWY_ATTR {
    return Point{hn::NegMulAdd(inv4, pp.x, from.x), hn::NegMulAdd(inv4, pp.y, from.y),
                 hn::NegMulAdd(inv4, pp.z, from.z)};
  };
  const Symmetric curvature{less(b.x, sums.pp.x), less(b.y, sums.pp.y), less(b.z, sums.pp.z)};

  totals.rewind();
  totals.add(sums.value);
  totals.add(sums.w);
  totals.add(sums.matched);
  totals.add(s);
  totals.add(cross(q, s));
  add_quadratic(curvature, q, totals);
  totals.add(scaled(s, q.x));
  totals.add(scaled(s, q.y));
  totals.add(scaled(s, q.z));
  add_quadratic(b, q, totals);
}

/// P of a group's kernels from a lane on.
HWY_INLINE Symmetric load_shapes(const PairTable::Group& group, std::size_t lane) {
  const auto load = [&](std::size_t i)
                        HWY_ATTR { return hn::Load(kTag, group.P[i].data() + lane); };
  const Floats xy = load(1);
  const Floats xz = load(2);
  const Floats yz = load(4);
  return {{load(0), xy, xz}, {xy, load(3), yz}, {xz, yz, load(5)}};
}

template <bool kShaped>
PairSums sum_groups(const PairTable& table, const SE3& T_fixed_moving, const KernelOptions& kernel,
                    double length_scale, std::size_t begin, std::size_t end) {
  const Constants constants(kernel, length_scale);
  const Floats inv2 = broadcast(1 / (length_scale * length_scale));
  const Motion motion(T_fixed_moving);
  PairTotals totals;
  for (std::size_t g = begin; g < end; ++g) {
    const PairTable::Group& group = table.groups()[g];
    for (std::size_t lane = 0; lane < PairTable::kLanes; lane += hn::Lanes(kTag)) {
      const Point q = motion * load(group, lane);
      const Symmetric P = load_shapes(group, lane);
      const LaneSums sums = sum_rows<kShaped>(constants, table.rows().data() + group.row_begin,
                                              table.rows().data() + group.row_end, lane, q, P);
      add_points(sums, q, P, inv2, totals);
    }
  }
  return std::bit_cast<PairSums>(totals.reduce());
}

PairSums sum_pairs(const PairTable& table, const SE3& T_fixed_moving, const KernelOptions& kernel,
                   double length_scale, std::size_t begin, std::size_t end) {
  const auto sum = table.has_shapes() ? sum_groups<true> : sum_groups<false>;
  return sum(table, T_fixed_moving, kernel, length_scale, begin, end);
}

/// Broadcasts a vector that is the same for all points.
HWY_INLINE Point broadcast(const Vector3& p) {
  return {broadcast(p.x()), broadcast(p.y()), broadcast(p.z())};
}

/// The terms of sum_expansion() that depend on the moving point alone.
struct PointFlow {
  PointFlow(const Point& omega, const Point& v, const Point& q)
      : u(cross(omega, q) + v),
        wu(cross(omega, u)),
        wwu(cross(omega, wu)),
        wwwu(cross(omega, wwu)),
        u2(dot(u, u)),
        wu2(dot(wu, wu)) {}
  Point u, wu, wwu, wwwu;
  Floats u2, wu2;
};

struct Expansion {
  Floats g1, g2, g3, g4;
};

/// Adds a pair with weight w and difference r = x - q.
HWY_INLINE void add_pair(const PointFlow& flow, Floats inv2, const Point& r, Floats w,
                         Expansion& sum) {
  const auto times = [](double f, Floats x) HWY_ATTR { return hn::Mul(broadcast(f), x); };
  const Floats beta = hn::Neg(hn::Mul(inv2, dot(flow.u, r)));
  const Floats gamma = times(-0.5, hn::Mul(inv2, hn::Sub(flow.u2, dot(flow.wu, r))));
  const Floats delta = times(-1.0 / 6, hn::Mul(inv2, dot(flow.wwu, r)));
  const Floats eps = times(1.0 / 24, hn::Mul(inv2, hn::Add(flow.wu2, dot(flow.wwwu, r))));
  const Floats beta2 = hn::Mul(beta, beta);
  const Floats g2 = hn::Add(gamma, times(0.5, beta2));
  const Floats g3 = hn::MulAdd(beta, gamma, hn::MulAdd(beta2, times(1.0 / 6, beta), delta));
  Floats g4 = hn::MulAdd(beta, delta, eps);
  g4 = hn::MulAdd(times(0.5, beta2), gamma, g4);
  g4 = hn::MulAdd(times(0.5, gamma), gamma, g4);
  g4 = hn::MulAdd(times(1.0 / 24, beta2), beta2, g4);
  sum.g1 = hn::MulAdd(w, beta, sum.g1);
  sum.g2 = hn::MulAdd(w, g2, sum.g2);
  sum.g3 = hn::MulAdd(w, g3, sum.g3);
  sum.g4 = hn::MulAdd(w, g4, sum.g4);
}

std::array<double, 4> sum_expansion(const PairTable& table, const SE3& T_fixed_moving,
                                    const KernelOptions& kernel, double length_scale,
                                    const Vector3& omega, const Vector3& v) {
  const Constants constants(kernel, length_scale);
  const Floats inv2 = broadcast(1 / (length_scale * length_scale));
  const Motion motion(T_fixed_moving);
  Totals<4> totals;
  for (const PairTable::Group& group : table.groups()) {
    for (std::size_t lane = 0; lane < PairTable::kLanes; lane += hn::Lanes(kTag)) {
      const Point q = motion * load(group, lane);
      const PointFlow flow(broadcast(omega), broadcast(v), q);
      const Floats zero = hn::Zero(kTag);
      Expansion sum{zero, zero, zero, zero};
      for (std::size_t i = group.row_begin; i < group.row_end; ++i) {
        const PairTable::Row& row = table.rows()[i];
        const Point r = load(row, lane) - q;
        const Floats k = constants.k(dot(r, r));
        const auto inside = hn::Gt(k, constants.threshold);
        const Floats w =
            hn::IfThenElseZero(inside, hn::Mul(k, hn::Load(kTag, row.c.data() + lane)));
        // Without the check, 0 times the square of a far-away padding could be 0 times infinity.
        const Point near{hn::IfThenElseZero(inside, r.x), hn::IfThenElseZero(inside, r.y),
                         hn::IfThenElseZero(inside, r.z)};
        add_pair(flow, inv2, near, w, sum);
      }
      totals.rewind();
      for (const Floats g : {sum.g1, sum.g2, sum.g3, sum.g4}) totals.add(g);
    }
  }
  return totals.reduce();
}

std::int64_t target() { return HWY_TARGET; }

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
HWY_EXPORT(sum_expansion);
HWY_EXPORT(simd_exp);
HWY_EXPORT(target);

PairSums sum_pairs(const PairTable& table, const SE3& T_fixed_moving, const KernelOptions& kernel,
                   double length_scale, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(sum_pairs)(table, T_fixed_moving, kernel, length_scale, begin, end);
}

std::array<double, 4> sum_expansion(const PairTable& table, const SE3& T_fixed_moving,
                                    const KernelOptions& kernel, double length_scale,
                                    const Vector3& omega, const Vector3& v) {
  return HWY_DYNAMIC_DISPATCH(sum_expansion)(table, T_fixed_moving, kernel, length_scale, omega, v);
}

std::int64_t compiled_simd_targets() { return HWY_TARGETS; }
std::int64_t simd_target_in_use() { return HWY_DYNAMIC_DISPATCH(target)(); }

std::vector<float> simd_exp(std::span<const float> x) {
  std::vector<float> y(x.size());
  HWY_DYNAMIC_DISPATCH(simd_exp)(x, y);
  return y;
}

}  // namespace cvo_slam
#endif
