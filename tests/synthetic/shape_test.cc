// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/shape_internal.h"

namespace cvo_slam::synthetic {
namespace {

const Cylinder kCylinder{0.6, 1.0};
const Sphere kSphere{0.8};

/// Returns the first point of the ray inside the solid, found in small steps; infinite if there is
/// none.
template <typename Solid>
double march(const Solid& solid, const Ray& ray, double step) {
  for (double t = step; t < 6; t += step) {
    if (distance(solid, ray.origin + t * ray.direction) == 0) return t;
  }
  return std::numeric_limits<double>::infinity();
}

/// Compares the hits of random rays from outside with those of small steps along the ray.
template <typename Solid>
void expect_agreement_with_marching(const Solid& solid) {
  constexpr double kStep = 1e-3;
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector3 origin =
        2 * Vector3(uniform(generator), uniform(generator), uniform(generator)).normalized();
    const Vector3 aim = 0.6 * Vector3(uniform(generator), uniform(generator), uniform(generator));
    const Ray ray{origin, (aim - origin).normalized()};
    const auto hit = intersect(solid, ray);
    const double marched = march(solid, ray, kStep);
    if (!hit) {
      EXPECT_TRUE(std::isinf(marched));
      continue;
    }
    ++hits;
    const Vector3 point = ray.origin + hit->distance * ray.direction;
    EXPECT_LT(distance(solid, point), 1e-12);
    // A chord shorter than a step may be missed.
    if (std::isfinite(marched)) {
      EXPECT_LT(hit->distance, marched + 1e-9);
      EXPECT_GT(hit->distance, marched - kStep - 1e-9);
    }
    const Surface surface = surface_at(solid, hit->face, point);
    EXPECT_LT(surface.normal.dot(ray.direction), 0) << "towards the viewer";
    EXPECT_NEAR(surface.normal.norm(), 1, 1e-12);
    EXPECT_NEAR((surface.right.cross(surface.down) + surface.normal).norm(), 0, 1e-12)
        << "readable from outside";
  }
  EXPECT_GT(hits, 100);
}

TEST(RoundShape, TheCylinderIsHitWhereItIs) { expect_agreement_with_marching(kCylinder); }
TEST(RoundShape, TheSphereIsHitWhereItIs) { expect_agreement_with_marching(kSphere); }

TEST(RoundShape, RaysAlongTheCylindersAxisHitItsEnds) {
  const auto from_above = intersect(kCylinder, {{0.1, 0, 2}, {0, 0, -1}});
  ASSERT_TRUE(from_above);
  EXPECT_DOUBLE_EQ(from_above->distance, 1.5);
  EXPECT_EQ(surface_at(kCylinder, from_above->face, {0.1, 0, 0.5}).normal, Vector3::UnitZ());
  const auto from_below = intersect(kCylinder, {{0.1, 0, -2}, {0, 0, 1}});
  ASSERT_TRUE(from_below);
  EXPECT_EQ(surface_at(kCylinder, from_below->face, {0.1, 0, -0.5}).normal, -Vector3::UnitZ());
  EXPECT_FALSE(intersect(kCylinder, {{0.4, 0, 2}, {0, 0, -1}}));
  EXPECT_FALSE(intersect(kCylinder, {{0.1, 0, 2}, {0, 0, 1}}));  // behind the ray's origin
}

TEST(RoundShape, FromInsideTheFarSideIsHit) {
  const auto side = intersect(kCylinder, {{0, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(side);
  EXPECT_DOUBLE_EQ(side->distance, 0.3);
  const auto ball = intersect(kSphere, {{0, 0, 0.1}, {0, 0, 1}});
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->distance, 0.3, 1e-15);
}

TEST(RoundShape, TheTexturesPositionMovesWithItsAxes) {
  constexpr double kStep = 1e-6;
  const Vector3 on_cylinder(0.3 * std::cos(1.0), 0.3 * std::sin(1.0), 0.2);
  const Vector3 on_sphere = 0.4 * Vector3(0.5, 0.6, 0.4).normalized();
  const auto expect_moves = [&](const auto& solid, const Vector3& point, int face) {
    const Surface here = surface_at(solid, face, point);
    const Surface right = surface_at(solid, face, point + kStep * here.right);
    const Surface below = surface_at(solid, face, point + kStep * here.down);
    EXPECT_NEAR(below.v - here.v, kStep, 1e-10);
    EXPECT_NEAR(below.u - here.u, 0, 1e-10);
    EXPECT_GT(right.u - here.u, 0.9 * kStep);
  };
  expect_moves(kCylinder, on_cylinder, 0);
  expect_moves(kSphere, on_sphere, 0);
}

// The silhouette of a sphere of radius r at distance d covers a cone of sin(angle) = r / d.
TEST(RoundShape, ASphereIsSeenAsLargeAsItIs) {
  WorldScene scene;
  scene.primitives.push_back({kSphere, SE3(Matrix3::Identity(), {0, 0, 2}), {}});
  const PinholeCamera camera = synthetic_camera(321, 241).color;
  const Rendering rendering = render(scene, camera, {});
  EXPECT_NEAR(rendering.depth.at<double>(120, 160), 1.6, 1e-12);
  const double radius = camera.fx * std::tan(std::asin(0.4 / 2));  // [px]
  int across = 0;
  for (int x = 0; x < camera.width; ++x) {
    across += rendering.depth.at<double>(120, x) > 0 ? 1 : 0;
  }
  EXPECT_EQ(across, 2 * static_cast<int>(radius) + 1);
}

TEST(RoundShape, ClearanceIsThatOfTheSolidNotOfItsBox) {
  WorldScene scene;
  scene.primitives.push_back({kCylinder, {}, {}});
  EXPECT_NEAR(clearance(scene, {0.3, 0.4, 0}), 0.2, 1e-15);
  EXPECT_NEAR(clearance(scene, {0.6, 0, 0.9}), 0.5, 1e-15);
  EXPECT_EQ(clearance(scene, {0.1, 0.1, 0.4}), 0);
  scene.primitives[0].shape = kSphere;
  EXPECT_NEAR(clearance(scene, {0.3, 0.4, 0}), 0.1, 1e-15);
}

TEST(RoundShape, ImpossibleSizesAreRefused) {
  WorldScene scene;
  scene.primitives.push_back({Cylinder{1, -1}, {}, {}});
  EXPECT_THROW(check(scene), OptionError);
  scene.primitives[0].shape = Sphere{0};
  EXPECT_THROW(check(scene), OptionError);
}

}  // namespace
}  // namespace cvo_slam::synthetic
