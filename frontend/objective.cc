// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <bit>

#include <Eigen/Geometry>

#include "cvo_slam/frontend/neighbor_search_internal.h"
#include "cvo_slam/frontend/objective_internal.h"
#include "cvo_slam/frontend/pair_sums_internal.h"

namespace cvo_slam {
namespace {

/// How much further than the kernel's support neighbours are searched, as a share of it: a pose may
/// change by so much before they are searched again. More finds more that are not needed.
constexpr double kSkin = 0.25;
/// Largest number of chunks of a sum. More gain nothing; fewer leave threads idle.
constexpr std::size_t kMaxChunks = 16;

void add(const PairSums& part, PairSums& total) {
  constexpr std::size_t kCount = sizeof(PairSums) / sizeof(double);
  using Array = std::array<double, kCount>;
  auto sum = std::bit_cast<Array>(total);
  const auto addend = std::bit_cast<Array>(part);
  for (std::size_t i = 0; i < kCount; ++i) sum[i] += addend[i];
  total = std::bit_cast<PairSums>(sum);
}

Vector3 vector(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// Returns the symmetric matrix with the entries xx, xy, xz, yy, yz, zz.
Matrix3 symmetric(const std::array<double, 6>& a) {
  Matrix3 m;
  m << a[0], a[1], a[2],  //
      a[1], a[3], a[4],   //
      a[2], a[4], a[5];
  return m;
}

Matrix3 from_columns(const std::array<double, 9>& a) {
  return Eigen::Map<const Eigen::Matrix3d>(a.data());
}

/// Computes the formulas of ObjectiveValue.
ObjectiveValue assemble(const PairSums& sums) {
  ObjectiveValue result;
  result.value = sums.value;
  result.inner_product = sums.w;
  result.matched = static_cast<std::size_t>(sums.matched);
  const Vector3 s = vector(sums.s);
  result.gradient << s, vector(sums.q_cross_s);

  const Matrix3 sq = from_columns(sums.sq);
  const Matrix3 vw = -from_columns(sums.AQ) - 0.5 * skew(s);
  result.hessian.topLeftCorner<3, 3>() = symmetric(sums.A);
  result.hessian.topRightCorner<3, 3>() = vw;
  result.hessian.bottomLeftCorner<3, 3>() = vw.transpose();
  result.hessian.bottomRightCorner<3, 3>() =
      symmetric(sums.QAQ) + sq.trace() * Matrix3::Identity() - 0.5 * (sq + sq.transpose());

  const Matrix3 BQ = from_columns(sums.BQ);
  result.majorizer.topLeftCorner<3, 3>() = symmetric(sums.B);
  result.majorizer.topRightCorner<3, 3>() = -BQ;
  result.majorizer.bottomLeftCorner<3, 3>() = -BQ.transpose();
  result.majorizer.bottomRightCorner<3, 3>() = symmetric(sums.QBQ);
  return result;
}

}  // namespace

void Objective::build(const PointCloud& fixed, const PointsByDepth& by_depth, std::size_t count,
                      const KernelOptions& kernel, double length_scale) {
  kernel_ = kernel;
  length_scale_ = length_scale;
  grid_.build(fixed, by_depth, count, (1 + kSkin) * support_radius(kernel, length_scale));
}

void Objective::build(const PointCloud& fixed, const KernelOptions& kernel, double length_scale) {
  PointsByDepth by_depth;
  by_depth.sort(fixed);
  build(fixed, by_depth, fixed.size(), kernel, length_scale);
}

double squared_norm(const NeighborGrid& grid, const PointCloud& cloud, const KernelOptions& kernel,
                    double length_scale, const Executor& executor) {
  const std::size_t chunk = std::max<std::size_t>(1, (cloud.size() + kMaxChunks - 1) / kMaxChunks);
  std::array<double, kMaxChunks> parts{};
  executor.for_each_chunk(
      cloud.size(), chunk, [&](std::size_t k, std::size_t begin, std::size_t end) {
        parts[k] = sum_inner_products(grid, cloud, kernel, length_scale, begin, end);
      });
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

PoseObjective::PoseObjective(const Objective& objective, const PointCloud& moving,
                             std::size_t count, PairTable& pairs, const Executor& executor)
    : objective_(objective), moving_(moving), count_(count), pairs_(pairs), executor_(executor) {
  if (!pairs_.reuse(objective.grid(), moving, count, objective.kernel(),
                    objective.length_scale())) {
    pairs_.clear();
  }
}

const PairTable& PoseObjective::pairs(const SE3& T_fixed_moving) {
  if (!pairs_.covers(T_fixed_moving)) {
    pairs_.build(objective_.grid(), moving_, count_, T_fixed_moving, objective_.kernel(),
                 objective_.length_scale(), executor_);
  }
  return pairs_;
}

ObjectiveValue PoseObjective::evaluate(const SE3& T_fixed_moving) {
  const PairTable& table = pairs(T_fixed_moving);
  const std::size_t groups = table.groups().size();
  const std::size_t chunk = std::max<std::size_t>(1, (groups + kMaxChunks - 1) / kMaxChunks);
  std::array<PairSums, kMaxChunks> parts;
  executor_.for_each_chunk(groups, chunk, [&](std::size_t k, std::size_t begin, std::size_t end) {
    parts[k] = sum_pairs(table, T_fixed_moving, objective_.kernel(), objective_.length_scale(),
                         begin, end);
  });
  PairSums total;
  for (const PairSums& part : parts) add(part, total);
  return assemble(total);
}

}  // namespace cvo_slam
