// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include <Eigen/Geometry>

#include "cvo_slam/frontend/objective_internal.h"

namespace cvo_slam {
namespace {

constexpr std::size_t kChunk = 128;

/// Adds what one moving point q contributes; the formulas are those of ObjectiveValue.
void add_point(const PairSums& sums, const Vector3& q, double ell, ObjectiveValue& total) {
  if (sums.k <= 0) return;
  const double w = sums.w;
  const double inv2 = 1 / (ell * ell);
  const double inv4 = inv2 * inv2;
  const Vector3 s(sums.r[0], sums.r[1], sums.r[2]);
  Matrix3 rr;
  rr << sums.rr[0], sums.rr[1], sums.rr[2],  //
      sums.rr[1], sums.rr[3], sums.rr[4],    //
      sums.rr[2], sums.rr[4], sums.rr[5];
  const Matrix3 Q = skew(q);

  total.value += sums.excess;
  total.inner_product += w;
  ++total.matched;
  total.gradient.head<3>() += inv2 * s;
  total.gradient.tail<3>() += inv2 * q.cross(s);

  const Matrix3 A = inv2 * w * Matrix3::Identity() - inv4 * rr;
  const Matrix3 AQ = A * Q;
  total.hessian.topLeftCorner<3, 3>() += A;
  total.hessian.topRightCorner<3, 3>() -= AQ + 0.5 * inv2 * skew(s);
  const Matrix3 sq = s * q.transpose();
  total.hessian.bottomRightCorner<3, 3>() +=
      inv2 * (s.dot(q) * Matrix3::Identity() - 0.5 * (sq + sq.transpose())) - Q * AQ;

  total.majorizer.topLeftCorner<3, 3>() += inv2 * w * Matrix3::Identity();
  total.majorizer.topRightCorner<3, 3>() -= inv2 * w * Q;
  total.majorizer.bottomRightCorner<3, 3>() -= inv2 * w * Q * Q;
}

void add(const ObjectiveValue& part, ObjectiveValue& total) {
  total.value += part.value;
  total.inner_product += part.inner_product;
  total.gradient += part.gradient;
  total.hessian += part.hessian;
  total.majorizer += part.majorizer;
  total.matched += part.matched;
}

void mirror_upper(Matrix6& m) { m.bottomLeftCorner<3, 3>() = m.topRightCorner<3, 3>().transpose(); }

}  // namespace

void Objective::build(const PointCloud& fixed, const KernelOptions& kernel, double length_scale) {
  kernel_ = kernel;
  length_scale_ = length_scale;
  grid_.build(fixed, support_radius(kernel, length_scale));
}

ObjectiveValue Objective::evaluate(const PointCloud& moving, const SE3& T_fixed_moving,
                                   const Executor& executor) const {
  std::vector<ObjectiveValue> parts(Executor::chunk_count(moving.size(), kChunk));
  executor.for_each_chunk(
      moving.size(), kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        std::array<PairSums, kChunk> sums;
        sum_pairs(grid_, moving, T_fixed_moving, kernel_, length_scale_, begin, end, sums.data());
        for (std::size_t j = begin; j < end; ++j) {
          add_point(sums[j - begin], T_fixed_moving * moving.position(j), length_scale_,
                    parts[chunk]);
        }
      });
  ObjectiveValue total;
  for (const auto& part : parts) add(part, total);
  mirror_upper(total.hessian);
  mirror_upper(total.majorizer);
  return total;
}

double Objective::squared_norm(const PointCloud& cloud) const {
  Objective self;
  self.build(cloud, kernel_, length_scale_);
  return self.evaluate(cloud, SE3(), Executor()).inner_product;
}

}  // namespace cvo_slam
