// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Queries of the grid against a search through all points.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "cvo_slam/frontend/neighbor_grid_internal.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// Returns the cloud's points that a query finds; checks that its runs are in bounds, not empty and
/// share no entry.
std::set<std::uint32_t> query(const NeighborGrid& grid, const Vector3& at) {
  std::array<GridRun, NeighborGrid::kMaxRuns> runs{};
  const std::size_t count = grid.query(static_cast<float>(at.x()), static_cast<float>(at.y()),
                                       static_cast<float>(at.z()), runs);
  EXPECT_LE(count, runs.size());
  std::set<std::uint32_t> found;
  for (std::size_t r = 0; r < count; ++r) {
    EXPECT_LT(runs[r].begin, runs[r].end);
    EXPECT_LE(runs[r].end, grid.size());
    for (std::uint32_t k = runs[r].begin; k < runs[r].end; ++k) {
      EXPECT_TRUE(found.insert(grid.order()[k]).second) << "in two runs";
    }
  }
  return found;
}

/// Returns how many points lie within `radius` of a position; each must have been found.
int expect_found(const PointCloud& cloud, const NeighborGrid& grid, const Vector3& at,
                 double radius) {
  const auto found = query(grid, at);
  int near = 0;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    // NaN counts as far.
    if (!((cloud.position(i) - at.cast<float>().cast<double>()).norm() < radius)) continue;
    ++near;
    EXPECT_TRUE(found.contains(i)) << "point " << i << " near " << at.transpose();
  }
  return near;
}

/// Columns are computed in single precision: in a cloud of some metres a position is exact to 1e-6
/// m, and a point that close to the radius, where the kernel is cut to zero, may be missed.
constexpr double kRounding = 1e-6;

TEST(NeighborGrid, FindsEveryPointWithinTheRadius) {
  const PointCloud cloud = random_cloud(2000, 1);
  std::mt19937 rng(2);
  std::uniform_real_distribution<double> place(-1.0, 2.5);  // the cloud's cube and 0.5 m around it
  for (const double radius : {0.01, 0.1, 0.3, 5.0}) {
    NeighborGrid grid;
    grid.build(cloud, radius);
    EXPECT_EQ(grid.radius(), radius);
    int near = 0;
    for (int i = 0; i < 300; ++i) {
      near += expect_found(cloud, grid, {place(rng), place(rng), place(rng)}, radius - kRounding);
    }
    for (std::uint32_t i = 0; i < cloud.size(); i += 20) {
      near += expect_found(cloud, grid, cloud.position(i), radius - kRounding);
    }
    EXPECT_GE(near, 100) << "each point finds itself at least";
  }
}

TEST(NeighborGrid, FindsEveryPointWithinAnEllipsoid) {
  const PointCloud cloud = random_cloud(3000, 11);
  constexpr double kRadius = 0.06;
  NeighborGrid grid;
  grid.build(cloud, kRadius);
  std::mt19937 rng(12);
  std::uniform_real_distribution<double> place(-0.7, 0.7);
  int near = 0;
  std::size_t found_in_all = 0;
  for (int i = 0; i < 400; ++i) {
    const Vector3 at(place(rng), place(rng), 1.5 + place(rng));
    // As rays are: most go along z, the widest at 60 degrees to it.
    const Vector3 along = Vector3(2.5 * place(rng), 2.5 * place(rng), 1).normalized();
    const double stretch = 1 + 3 * std::abs(place(rng));
    std::array<GridRun, NeighborGrid::kMaxRuns> runs{};
    const std::size_t count =
        grid.query(at.cast<float>(), along.cast<float>(), static_cast<float>(stretch), runs);
    std::set<std::uint32_t> found;
    for (std::size_t r = 0; r < count; ++r) {
      for (std::uint32_t k = runs[r].begin; k < runs[r].end; ++k) {
        EXPECT_TRUE(found.insert(grid.order()[k]).second) << "in two runs";
      }
    }
    found_in_all += found.size();
    for (std::uint32_t p = 0; p < cloud.size(); ++p) {
      const Vector3 r = cloud.position(p) - at;
      const double t = r.dot(along);
      const double across2 = r.squaredNorm() - t * t;
      if (across2 + t * t / (stretch * stretch) > std::pow(kRadius - kRounding, 2)) continue;
      ++near;
      EXPECT_TRUE(found.contains(p)) << at.transpose();
    }
  }
  EXPECT_GT(near, 400);
  EXPECT_LT(found_in_all, 20U * static_cast<unsigned>(near)) << "not much more than it must";
}

TEST(NeighborGrid, OrderIsAPermutationThatTheSortedPointsFollow) {
  const PointCloud cloud = random_cloud(500, 3);
  NeighborGrid grid;
  grid.build(cloud, 0.1);
  ASSERT_EQ(grid.size(), cloud.size());
  ASSERT_EQ(grid.points().size(), cloud.size() + NeighborGrid::kPadding);
  EXPECT_EQ(std::set<std::uint32_t>(grid.order().begin(), grid.order().end()).size(), cloud.size());
  for (std::size_t k = 0; k < grid.size(); ++k) {
    const std::size_t i = grid.order()[k];
    ASSERT_LT(i, cloud.size());
    EXPECT_EQ(grid.points().position(k), cloud.position(i));
    for (std::size_t f = 0; f < PointCloud::kFeatures; ++f) {
      EXPECT_EQ(grid.points().features[f][k], cloud.features[f][i]);
    }
  }
}

TEST(NeighborGrid, IsASmallPartOfTheCloudThatIsSearched) {
  // 3x3 columns of 0.05 m out of 1 m x 1 m, 0.1 m of 1 m in x: 0.23 % of the volume.
  const PointCloud cloud = random_cloud(10000, 4);
  NeighborGrid grid;
  grid.build(cloud, 0.05);
  EXPECT_LT(query(grid, {0, 0, 1.5}).size(), 100U);
}

TEST(NeighborGrid, LeavesOutPointsThatAreNotFinite) {
  PointCloud cloud = random_cloud(100, 5);
  cloud.x[10] = kNan;
  cloud.y[20] = kInf;
  cloud.z[30] = -kInf;
  NeighborGrid grid;
  grid.build(cloud, 0.2);
  EXPECT_EQ(grid.size(), 97U);
  for (const std::uint32_t i : {10U, 20U, 30U}) {
    EXPECT_EQ(std::count(grid.order().begin(), grid.order().end(), i), 0);
  }
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (cloud.position(i).allFinite()) {
      expect_found(cloud, grid, cloud.position(i), 0.2 - kRounding);
    }
  }
}

TEST(NeighborGrid, OfACloudWithoutPointsFindsNothing) {
  PointCloud nowhere = random_cloud(3, 6);
  nowhere.z = {kNan, kNan, kNan};
  for (const PointCloud& cloud : {PointCloud(), nowhere}) {
    NeighborGrid grid;
    grid.build(cloud, 0.1);
    EXPECT_EQ(grid.size(), 0U);
    EXPECT_TRUE(query(grid, {0, 0, 0}).empty());
    EXPECT_TRUE(query(grid, {kNan, 0, 1}).empty());
  }
}

TEST(NeighborGrid, OfOnePoint) {
  const PointCloud cloud = random_cloud(1, 7);
  NeighborGrid grid;
  grid.build(cloud, 0.1);
  const Vector3 p = cloud.position(0);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      EXPECT_EQ(query(grid, p + side * 0.099 * Vector3::Unit(axis)).size(), 1U);
      EXPECT_EQ(query(grid, p + side * 0.301 * Vector3::Unit(axis)).size(), 0U)
          << "beyond three columns";
    }
  }
}

TEST(NeighborGrid, OfEqualPointsFindsAllOrNone) {
  PointCloud cloud = random_cloud(50, 8);
  std::fill(cloud.x.begin(), cloud.x.end(), 1.0F);
  std::fill(cloud.y.begin(), cloud.y.end(), -2.0F);
  std::fill(cloud.z.begin(), cloud.z.end(), 3.0F);
  NeighborGrid grid;
  grid.build(cloud, 0.1);
  EXPECT_EQ(query(grid, {1.05, -2.05, 3.05}).size(), 50U);
  EXPECT_EQ(query(grid, {1.5, -2, 3}).size(), 0U);
}

TEST(NeighborGrid, OfAWideCloudHasWiderColumnsAndIsStillRight) {
  // Columns as wide as the radius would be 1e13 in number. Floats near 1e6 m are 0.06 m apart, so
  // points half a metre around a hundred places are neighbours at a radius of 0.5 m.
  std::mt19937 rng(9);
  std::uniform_real_distribution<float> place(-1e6F, 1e6F);
  std::uniform_real_distribution<float> around(-0.5F, 0.5F);
  PointCloud cloud = random_cloud(2000, 10);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool first = i % 20 == 0;
    cloud.x[i] = first ? place(rng) : cloud.x[i - i % 20] + around(rng);
    cloud.y[i] = first ? place(rng) : cloud.y[i - i % 20] + around(rng);
    cloud.z[i] = first ? place(rng) : cloud.z[i - i % 20] + around(rng);
  }
  NeighborGrid grid;
  grid.build(cloud, 0.5);
  int near = 0;
  for (std::uint32_t i = 0; i < cloud.size(); i += 7) {
    near += expect_found(cloud, grid, cloud.position(i), 0.5);
  }
  EXPECT_GT(near, 1000) << "several neighbours each";
}

TEST(NeighborGrid, OfALongRowFindsNeighboursToOneInAHundred) {
  // 60,000 columns in a row: the largest index, which single precision knows to 4e-3.
  PointCloud cloud = random_cloud(5000, 11);
  std::mt19937 rng(12);
  std::uniform_real_distribution<float> along(0.0F, 6000.0F);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.x[i] = cloud.z[i] = 0;
    cloud.y[i] = i % 2 == 0 ? along(rng) : cloud.y[i - 1] + 0.098F;
  }
  NeighborGrid grid;
  grid.build(cloud, 0.1);
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    expect_found(cloud, grid, cloud.position(i), 0.099);
  }
}

TEST(NeighborGrid, PlacesThatAreNotNumbersOrFarAwayFindNothing) {
  NeighborGrid grid;
  grid.build(random_cloud(200, 13), 0.2);
  for (const float odd : {kNan, kInf, -kInf, 1e30F, -1e30F, 3e38F}) {
    EXPECT_TRUE(query(grid, {0, odd, 1.5}).empty()) << odd;
    EXPECT_TRUE(query(grid, {0, 0, odd}).empty()) << odd;
    EXPECT_TRUE(query(grid, {odd, odd, odd}).empty()) << odd;
    query(grid, {odd, 0, 1.5});  // NaN here may find anything, in valid runs
  }
}

TEST(NeighborGrid, RadiusZeroFindsThePointItself) {
  const PointCloud cloud = random_cloud(300, 14);
  NeighborGrid grid;
  grid.build(cloud, 0);
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    EXPECT_TRUE(query(grid, cloud.position(i)).contains(i));
  }
}

TEST(NeighborGrid, CanBeBuiltAgain) {
  NeighborGrid grid;
  grid.build(random_cloud(1000, 15), 0.05);
  const PointCloud cloud = random_cloud(20, 16);
  grid.build(cloud, 0.3);
  EXPECT_EQ(grid.size(), 20U);
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    expect_found(cloud, grid, cloud.position(i), 0.3 - kRounding);
  }
}

}  // namespace
}  // namespace cvo_slam
