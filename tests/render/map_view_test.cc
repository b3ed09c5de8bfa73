// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/render/map_view.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/render/test_scenes.h"

namespace cvo_slam::render {
namespace {

TEST(MapView, PerspectiveIsThatOfTheCoresCamera) {
  const MapScene scene = floor_scene();
  for (const ViewKind kind : {ViewKind::kIso, ViewKind::kTurntable, ViewKind::kFollow}) {
    const MapView view = make_view(scene, {.kind = kind, .progress = 0.5});
    for (const Vector3& point : {Vector3(0, 0.2, 1), Vector3(0.3, 0.9, 0.4)}) {
      const Vector3 in_view = view.T_world_view.inverse() * point;
      const Eigen::Vector2d pixel = view.camera.project(in_view);
      EXPECT_LT((view.project(point).head<2>() - pixel).norm(), 1e-9);
      EXPECT_NEAR(view.project(point).z(), in_view.z(), 1e-12);
    }
  }
}

TEST(MapView, FramesEverythingWithAMargin) {
  const MapScene scene = floor_scene();
  for (const auto& [name, kind] : view_names()) {
    if (kind == ViewKind::kFollow) continue;  // looks at what is ahead
    for (const auto& [width, height] : {std::pair(640, 480), {200, 900}, {4096, 64}}) {
      for (const double azimuth : {0.0, 1.0, 4.0}) {
        const MapView view =
            make_view(scene, {.kind = kind, .width = width, .height = height, .azimuth = azimuth});
        double filled = 0;
        for (const MapPoint& point : scene.points) {
          const Vector3 p = view.project(point.position.cast<double>());
          const double x = std::abs(2 * (p.x() + 0.5) / width - 1);
          const double y = std::abs(2 * (p.y() + 0.5) / height - 1);
          filled = std::max({filled, x, y});
          EXPECT_GT(view.buffer_depth(p.z()), 0);
          EXPECT_LT(view.buffer_depth(p.z()), 1);
        }
        // Less than the picture, which has space for labels, and more than half of it.
        EXPECT_LT(filled, 0.87) << name;
        EXPECT_GT(filled, 0.5) << name;
      }
    }
  }
}

TEST(MapView, TopIsAMapWithXToTheRightAndYUp) {
  const MapView view = make_view(floor_scene(), {.kind = ViewKind::kTop});
  const Vector3 origin = view.project({0, 0, 0});
  const Vector3 x = view.project({1, 0, 0});
  const Vector3 y = view.project({0, 1, 0.7});
  EXPECT_NEAR(x.x() - origin.x(), view.camera.fx, 1e-9);  // a metre is fx pixels
  EXPECT_NEAR(x.y(), origin.y(), 1e-9);
  EXPECT_NEAR(origin.y() - y.y(), view.camera.fx, 1e-9);
  EXPECT_LT(y.z(), origin.z());  // higher is nearer
}

TEST(MapView, FrontAndSideHaveUpUp) {
  for (const ViewKind kind : {ViewKind::kFront, ViewKind::kSide}) {
    const MapView view = make_view(floor_scene(), {.kind = kind});
    EXPECT_LT(view.project({0, 0, 1}).y(), view.project({0, 0, 0}).y());
  }
}

TEST(MapView, ATurntableComesBackAfterAWholeTurn) {
  const MapScene scene = floor_scene();
  const MapView start = make_view(scene, {.kind = ViewKind::kIso});
  const MapView turned =
      make_view(scene, {.kind = ViewKind::kTurntable, .azimuth = 2 * std::numbers::pi});
  const MapView opposite =
      make_view(scene, {.kind = ViewKind::kTurntable, .azimuth = std::numbers::pi});
  EXPECT_LT((start.T_world_view.matrix() - turned.T_world_view.matrix()).norm(), 1e-9);
  EXPECT_LT(start.T_world_view.translation().x() * opposite.T_world_view.translation().x(), 0);
}

TEST(MapView, AxesAreAlongTheWallsOfATurnedRoom) {
  MapScene scene;
  scene.up = Vector3::UnitZ();
  const double angle = 0.3;
  const Vector3 along(std::cos(angle), std::sin(angle), 0);
  const Vector3 across(-std::sin(angle), std::cos(angle), 0);
  add_wall(scene, {0, 0, 0}, along, Vector3::UnitZ(), 1, {9, 9, 9}, across);
  const MapView view = make_view(scene, {.kind = ViewKind::kTop});
  EXPECT_NEAR(view.project(along).y(), view.project({0, 0, 0}).y(), 1e-3);
}

TEST(MapView, EnlargedKeepsThePicturesCorner) {
  const MapView view = make_view(floor_scene(), {});
  const Vector3 p = view.project({0.3, 0.2, 0.1});
  const Vector3 q = enlarged(view, 2).project({0.3, 0.2, 0.1});
  // The corner of the upper left pixel is at -0.5.
  EXPECT_NEAR(q.x() + 0.5, 2 * (p.x() + 0.5), 1e-9);
  EXPECT_NEAR(q.y() + 0.5, 2 * (p.y() + 0.5), 1e-9);
}

TEST(MapView, ImpossibleSizesAndAFollowWithoutAPathAreErrors) {
  const MapScene scene = floor_scene();
  for (const auto& [width, height] : {std::pair(0, 480), {640, -1}, {5000, 100}, {63, 64}}) {
    EXPECT_THROW(static_cast<void>(make_view(scene, {.width = width, .height = height})),
                 OptionError);
  }
  MapScene points;
  points.points = scene.points;
  EXPECT_THROW(static_cast<void>(make_view(points, {.kind = ViewKind::kFollow})), OptionError);
}

}  // namespace
}  // namespace cvo_slam::render
