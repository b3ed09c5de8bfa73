// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/render/renderer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/render/gl_context_internal.h"
#include "cvo_slam/tests/render/test_scenes.h"

namespace cvo_slam::render {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr ViewOptions kSmall = {.width = 480, .height = 360};

TEST(Renderer, AKnownPointLandsOnTheRightPixel) {
  for (const auto& renderer : all_renderers()) {
    for (const ViewKind kind : {ViewKind::kIso, ViewKind::kTop, ViewKind::kSide}) {
      MapScene scene;
      scene.up = Vector3::UnitZ();
      // Two dark corners that decide the framing, and a red point between them.
      scene.points = {map_point({-1, -1, 0}, {30, 30, 30}), map_point({1, 1, 1}, {30, 30, 30}),
                      map_point({0.31, -0.42, 0.55}, {255, 0, 0})};
      scene.point_size = 0.08;
      ViewOptions options = kSmall;
      options.kind = kind;
      const MapView view = make_view(scene, options);
      const auto red = pixels_where(draw_picture(scene, options, *renderer).image, is_red);
      ASSERT_GT(red.size(), 20U) << renderer->name();
      Eigen::Vector2d center = Eigen::Vector2d::Zero();
      for (const cv::Point& pixel : red) center += Eigen::Vector2d(pixel.x, pixel.y);
      center /= static_cast<double>(red.size());
      const Vector3 expected = view.project({0.31, -0.42, 0.55});
      EXPECT_LT((center - expected.head<2>()).norm(), 0.35) << renderer->name();
    }
  }
}

TEST(Renderer, WhatIsBehindAWallIsHidden) {
  for (const auto& renderer : all_renderers()) {
    MapScene scene;
    scene.up = Vector3::UnitZ();
    add_wall(scene, {0, 0, 0}, Vector3::UnitX(), Vector3::UnitY(), 0.3, {255, 0, 0});
    const ViewOptions top = {.kind = ViewKind::kTop, .width = 480, .height = 360};
    EXPECT_GT(pixels_where(draw_picture(scene, top, *renderer).image, is_red).size(), 1000U);
    // A roof above it is drawn after it: the order must not matter.
    add_wall(scene, {0, 0, 1}, Vector3::UnitX(), Vector3::UnitY(), 0.5, {0, 0, 255});
    EXPECT_EQ(pixels_where(draw_picture(scene, top, *renderer).image, is_red).size(), 0U)
        << renderer->name();
  }
}

TEST(Renderer, OneLooksThroughTheBackOfACeiling) {
  for (const auto& renderer : all_renderers()) {
    MapScene scene;
    scene.up = Vector3::UnitZ();
    add_wall(scene, {0, 0, 0}, Vector3::UnitX(), Vector3::UnitY(), 0.3, {255, 0, 0},
             Vector3::UnitZ());
    add_wall(scene, {0, 0, 1}, Vector3::UnitX(), Vector3::UnitY(), 0.5, {0, 0, 255},
             -Vector3::UnitZ());
    const ViewOptions top = {.kind = ViewKind::kTop, .width = 480, .height = 360};
    EXPECT_GT(pixels_where(draw_picture(scene, top, *renderer).image, is_red).size(), 1000U)
        << renderer->name();
  }
}

TEST(Renderer, ADenseSurfaceHasNoHoles) {
  MapScene scene;
  scene.up = Vector3::UnitZ();
  add_wall(scene, {0, 0, 0}, Vector3::UnitX(), Vector3::UnitY(), 0.5, {255, 0, 0},
           Vector3::UnitZ());
  for (const auto& renderer : all_renderers()) {
    for (const ViewKind kind : {ViewKind::kTop, ViewKind::kIso}) {
      ViewOptions options = kSmall;
      options.kind = kind;
      const MapView view = make_view(scene, options);
      const cv::Mat image = draw_picture(scene, options, *renderer).image;
      // Positions inside the square that the axes do not cover.
      for (double x = -0.4; x < -0.1; x += 0.01) {
        const Vector3 p = view.project({x, 0.1, 0});
        const auto& pixel = image.at<cv::Vec3b>(static_cast<int>(std::lround(p.y())),
                                                static_cast<int>(std::lround(p.x())));
        EXPECT_TRUE(is_red(pixel)) << renderer->name() << " at " << x;
      }
    }
  }
}

TEST(Renderer, OpenGlDrawsWhatTheSplatterDraws) {
  const MapScene scene = floor_scene();
  const auto& renderers = all_renderers();
  for (const ViewKind kind : {ViewKind::kIso, ViewKind::kTop, ViewKind::kFollow}) {
    ViewOptions options = kSmall;
    options.kind = kind;
    const cv::Mat expected = draw_picture(scene, options, *renderers[0]).image;
    for (const auto& renderer : renderers) {
      cv::Mat difference;
      cv::absdiff(draw_picture(scene, options, *renderer).image, expected, difference);
      // Pixels on the rims of splats and lines may differ: llvmpipe rounds positions to
      // 1/256 pixel. A picture that is moved by a pixel differs in several times as many.
      const auto differing = pixels_where(difference, [](const cv::Vec3b& d) {
        return std::max({d[0], d[1], d[2]}) > 40;
      });
      EXPECT_LT(static_cast<double>(differing.size()), 0.01 * static_cast<double>(expected.total()))
          << renderer->name();
      EXPECT_LT(cv::mean(difference)[0], 0.7) << renderer->name();
    }
  }
}

TEST(Renderer, DrawsTheSameBytesAgain) {
  const MapScene scene = floor_scene();
  for (const auto& renderer : all_renderers()) {
    const cv::Mat first = draw_picture(scene, kSmall, *renderer).image;
    const cv::Mat again = draw_picture(scene, kSmall, *renderer).image;
    EXPECT_EQ(cv::norm(first, again, cv::NORM_INF), 0) << renderer->name();
  }
}

TEST(Renderer, ALibraryThatIsMissingIsAnErrorThatSaysWhatToInstall) {
  const auto message_of = [](const auto& make) {
    try {
      static_cast<void>(make());
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message_of([] { return make_osmesa_context("libnone.so.1"); }),
              AllOf(HasSubstr("libnone.so.1 cannot be loaded"), HasSubstr("libosmesa6"),
                    HasSubstr("splat")));
  EXPECT_THAT(message_of([] { return make_egl_context("libnone.so.1"); }),
              AllOf(HasSubstr("libnone.so.1 cannot be loaded"), HasSubstr("libegl1")));
  // The library exists, but it is another one.
  EXPECT_THAT(message_of([] { return make_osmesa_context("libm.so.6"); }),
              HasSubstr("libm.so.6 has no function OSMesaMakeCurrent"));
}

TEST(Renderer, AnImpossibleImageIsAnError) {
  const auto osmesa = make_renderer(RendererKind::kOsmesa);
  EXPECT_THROW(static_cast<void>(osmesa->draw({}, {100'000, 4}, kGrey)), Error);
  EXPECT_EQ(osmesa->draw({}, {4, 4}, kGrey).color.size(), cv::Size(4, 4));  // and works on
}

}  // namespace
}  // namespace cvo_slam::render
