// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/synthetic/ray_caster_internal.h"
#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"
#include "cvo_slam/tests/synthetic/reprojection.h"

namespace cvo_slam::synthetic {
namespace {

const PinholeCamera kCamera = synthetic_camera(160, 120).color;

cv::Mat grey_at(const World& world, double seconds) {
  cv::Mat grey;
  cv::cvtColor(render(world.scene, kCamera, world.path.T_world_camera(seconds)).color, grey,
               cv::COLOR_BGR2GRAY);
  return grey;
}

std::string name_of(bool structure, bool texture, bool near) {
  return fmt::format("{}_{}_{}", structure ? "structure" : "nostructure",
                     texture ? "texture" : "notexture", near ? "near" : "far");
}

TEST(Panels, PaintWithoutTextureKeepsTwoGreyLevels) {
  for (const bool structure : {true, false}) {
    for (const bool near : {true, false}) {
      const World world = make_world(name_of(structure, false, near));
      World smooth = world;
      for (auto& primitive : smooth.scene.primitives) primitive.texture.contrast = 0;
      for (const double t : {1.0, 6.0, 11.0}) {
        // The contrast of the paint without the shades of the light.
        const cv::Mat residual = grey_at(world, t) - grey_at(smooth, t);
        const std::vector<double> levels(residual.begin<float>(), residual.end<float>());
        const double contrast = quantile(levels, 0.99) - quantile(levels, 0.01);
        EXPECT_NEAR(contrast, 2, 0.7) << name_of(structure, false, near) << " at " << t;
      }
    }
  }
}

TEST(Panels, TexturesAreStrong) {
  for (const bool structure : {true, false}) {
    for (const bool near : {true, false}) {
      const cv::Mat grey = grey_at(make_world(name_of(structure, true, near)), 3);
      cv::Scalar mean;
      cv::Scalar deviation;
      cv::meanStdDev(grey, mean, deviation);
      EXPECT_GT(deviation[0], 25) << name_of(structure, true, near);
    }
  }
}

/// Returns the RMS distance of the image's points from their best-fitting plane [m].
double unevenness(const World& world, double seconds) {
  const RayCaster rays(world.scene, kCamera, world.path.T_world_camera(seconds));
  Eigen::MatrixX3d points(kCamera.width * kCamera.height, 3);
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      points.row(y * kCamera.width + x) =
          rays.look(x, y).depth * kCamera.unproject({x, y}).transpose();
    }
  }
  points.rowwise() -= points.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(points.transpose() * points);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[0]) / static_cast<double>(points.rows()));
}

TEST(Panels, NoStructureIsOnePlaneAndStructureIsNot) {
  for (const bool texture : {true, false}) {
    for (const bool near : {true, false}) {
      EXPECT_LT(unevenness(make_world(name_of(false, texture, near)), 4), 1e-6);
      // Folds of 0.6 m by 35 degrees are 0.34 m deep from edge to edge: uniform over that is 0.1 m.
      EXPECT_GT(unevenness(make_world(name_of(true, texture, near)), 4), 0.07);
    }
  }
}

TEST(Panels, NearIsOneMetreAndFarTwo) {
  for (const bool structure : {true, false}) {
    for (const bool near : {true, false}) {
      const World world = make_world(name_of(structure, true, near));
      std::vector<double> depths;
      for (const double t : {0.0, 4.0, 9.0}) {
        const RayCaster rays(world.scene, kCamera, world.path.T_world_camera(t));
        depths.push_back(rays.look(80, 60).depth);
      }
      EXPECT_NEAR(quantile(depths, 0.5), near ? 1.0 : 2.0, 0.3) << name_of(structure, true, near);
    }
  }
}

}  // namespace
}  // namespace cvo_slam::synthetic
