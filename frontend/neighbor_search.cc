// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which points of a grid a kernel reaches. Compiled as pair_sums.cc is.
// Vectors are members of structs here, which Arm's scalable vectors cannot be.
#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_AVX3_DL)
// The scalar path too, and not every step between.
#define HWY_COMPILE_ALL_ATTAINABLE
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cvo_slam/frontend/neighbor_search.cc"
#include <array>
#include <cmath>

#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "cvo_slam/frontend/kernel_shape_internal.h"
#include "cvo_slam/frontend/neighbor_search_internal.h"
#include "cvo_slam/frontend/simd_internal.h"

HWY_BEFORE_NAMESPACE();
namespace cvo_slam::HWY_NAMESPACE {
namespace {

/// Where the kernel of a point reaches: a ball, or an ellipsoid that is longer along a =
/// sqrt(alpha) d (zero for a ball).
struct Reach {
  Reach(const Vector3& ray, double radius)
      : a{broadcast(ray.x()), broadcast(ray.y()), broadcast(ray.z())},
        along(ray.cast<float>()),
        radius2(broadcast(radius * radius)) {
    const double alpha = ray.squaredNorm();
    if (alpha > 0) along /= static_cast<float>(std::sqrt(alpha));
    stretch = static_cast<float>(1 / std::sqrt(1 - alpha));
  }
  Point a;
  Eigen::Array3f along;
  float stretch = 1;
  Floats radius2;
};

/// Calls visit(k, inside, x, d2) for each vector of grid points with any within reach of q; d2 is
/// r^T (I - a a^T) r.
template <typename Visit>
HWY_INLINE void for_each_neighbor(const NeighborGrid& grid, const Vector3& position, const Point& q,
                                  const Reach& reach, const Visit& visit) {
  std::array<GridRun, NeighborGrid::kMaxRuns> runs;
  const Eigen::Array3f center = position.cast<float>();
  const std::size_t count = reach.stretch > 1
                                ? grid.query(center, reach.along, reach.stretch, runs)
                                : grid.query(center.x(), center.y(), center.z(), runs);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = runs[i].begin; k < runs[i].end; k += hn::Lanes(kTag)) {
      const Point x = load_position(grid.points(), k);
      const Point r = x - q;
      const Floats ar = dot(reach.a, r);
      const Floats d2 = hn::NegMulAdd(ar, ar, dot(r, r));
      const auto inside = hn::And(hn::FirstN(kTag, runs[i].end - k), hn::Lt(d2, reach.radius2));
      if (!hn::AllFalse(kTag, inside)) visit(k, inside, x, d2);
    }
  }
}

/// Makes room for `more` entries and the unused rest of a vector.
void reserve(NeighborLists& lists, std::size_t more) {
  const std::size_t needed = lists.used + more + PairTable::kLanes;
  if (lists.x.size() >= needed) return;
  for (auto* array : {&lists.x, &lists.y, &lists.z, &lists.c}) array->resize(2 * needed);
}

template <ColorKernel kColor>
void find_all(const NeighborGrid& grid, const PointCloud& moving, const SE3& T_fixed_moving,
              const KernelOptions& kernel, double length_scale, std::size_t begin, std::size_t end,
              NeighborLists& lists) {
  const Constants constants(kernel);
  lists.used = 0;
  lists.count.resize(end - begin);
  for (std::size_t j = begin; j < end; ++j) {
    const Vector3 position = T_fixed_moving * moving.position(j);
    const MovedPoint point(moving, j, position);
    const std::size_t first = lists.used;
    const Reach reach(T_fixed_moving.rotation() * kernel_ray(moving, j, kernel, length_scale),
                      grid.radius());
    for_each_neighbor(grid, position, point.q, reach,
                      [&](std::size_t k, auto inside, const Point& x, Floats) HWY_ATTR {
                        reserve(lists, hn::Lanes(kTag));
                        const Floats c = label_products<kColor>(constants, grid.points(), k, point);
                        // Compress in a register: stores that compress are slow on some CPUs.
                        const auto append = [&](Floats v, std::vector<float>& to) HWY_ATTR {
                          hn::StoreU(hn::Compress(v, inside), kTag, to.data() + lists.used);
                        };
                        append(x.x, lists.x);
                        append(x.y, lists.y);
                        append(x.z, lists.z);
                        append(c, lists.c);
                        lists.used += hn::CountTrue(kTag, inside);
                      });
    lists.count[j - begin] = static_cast<std::uint32_t>(lists.used - first);
  }
}

template <ColorKernel kColor>
double inner_products(const NeighborGrid& grid, const PointCloud& moving,
                      const KernelOptions& kernel, double length_scale, std::size_t begin,
                      std::size_t end) {
  const Constants constants(kernel, length_scale);
  const double radius = support_radius(kernel, length_scale);
  double total = 0;
  for (std::size_t j = begin; j < end; ++j) {
    const Vector3 position = moving.position(j);
    const MovedPoint point(moving, j, position);
    Floats sum = hn::Zero(kTag);
    const Reach reach(Vector3::Zero(), radius);
    for_each_neighbor(grid, position, point.q, reach,
                      [&](std::size_t k, auto inside, const Point&, Floats d2) HWY_ATTR {
                        const Floats c = label_products<kColor>(constants, grid.points(), k, point);
                        sum = hn::Add(sum, hn::IfThenElseZero(inside, hn::Mul(c, constants.k(d2))));
                      });
    total += hn::GetLane(hn::SumOfLanes(kTag, sum));
  }
  return total;
}

void find_neighbors(const NeighborGrid& grid, const PointCloud& moving, const SE3& T_fixed_moving,
                    const KernelOptions& kernel, double length_scale, std::size_t begin,
                    std::size_t end, NeighborLists& lists) {
  const auto find = kernel.color_kernel == ColorKernel::kLinear
                        ? find_all<ColorKernel::kLinear>
                        : find_all<ColorKernel::kSquaredExponential>;
  find(grid, moving, T_fixed_moving, kernel, length_scale, begin, end, lists);
}

double sum_inner_products(const NeighborGrid& grid, const PointCloud& moving,
                          const KernelOptions& kernel, double length_scale, std::size_t begin,
                          std::size_t end) {
  const auto sum = kernel.color_kernel == ColorKernel::kLinear
                       ? inner_products<ColorKernel::kLinear>
                       : inner_products<ColorKernel::kSquaredExponential>;
  return sum(grid, moving, kernel, length_scale, begin, end);
}

}  // namespace
}  // namespace cvo_slam::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cvo_slam {

HWY_EXPORT(find_neighbors);
HWY_EXPORT(sum_inner_products);

void find_neighbors(const NeighborGrid& grid, const PointCloud& moving, const SE3& T_fixed_moving,
                    const KernelOptions& kernel, double length_scale, std::size_t begin,
                    std::size_t end, NeighborLists& lists) {
  HWY_DYNAMIC_DISPATCH(find_neighbors)
  (grid, moving, T_fixed_moving, kernel, length_scale, begin, end, lists);
}

double sum_inner_products(const NeighborGrid& grid, const PointCloud& moving,
                          const KernelOptions& kernel, double length_scale, std::size_t begin,
                          std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(sum_inner_products)(grid, moving, kernel, length_scale, begin, end);
}

}  // namespace cvo_slam
#endif
