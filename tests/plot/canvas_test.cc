// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Line patterns, images in panels, and panels of several columns.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/plot/canvas_internal.h"
#include "cvo_slam/plot/figure.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::pair<double, double>> ends_along_x(
    const std::vector<std::vector<CanvasPoint>>& strokes) {
  std::vector<std::pair<double, double>> ends;
  ends.reserve(strokes.size());
  for (const auto& stroke : strokes) ends.emplace_back(stroke.front().x, stroke.back().x);
  return ends;
}

TEST(DashedLine, HasStrokesAndGapsInTurn) {
  const auto strokes = strokes_of({{0, 0}, {10, 0}}, {3, 2});
  EXPECT_THAT(ends_along_x(strokes),
              testing::ElementsAre(testing::Pair(0, 3), testing::Pair(5, 8)));
}

TEST(DashedLine, GoesOnAroundCornersWhereItWas) {
  // The first stroke ends 1 px behind the corner.
  const auto strokes = strokes_of({{0, 0}, {2, 0}, {2, 5}}, {3, 2});
  ASSERT_EQ(strokes.size(), 2U);
  ASSERT_EQ(strokes[0].size(), 3U);
  EXPECT_DOUBLE_EQ(strokes[0].back().y, 1);
  EXPECT_DOUBLE_EQ(strokes[1].front().y, 3);
  EXPECT_DOUBLE_EQ(strokes[1].back().y, 5);
}

TEST(DashedLine, WithoutAPatternIsTheLine) {
  EXPECT_EQ(strokes_of({{0, 0}, {1, 0}, {2, 0}}, {}).at(0).size(), 3U);
  EXPECT_TRUE(strokes_of({{0, 0}}, {3, 2}).empty());
}

/// Two pictures beside a curve that is as wide as both.
Figure small_figure() {
  Panel wide{"Wide", "x", "y", {{"dashed", {0, 1}, {0, 1}}}};
  wide.series[0].pattern = LinePattern::kDashed;
  wide.span = 2;
  Panel picture{"Picture", "u", "v", {}};
  picture.image = in_pixels(cv::Mat(2, 4, CV_8UC3, cv::Scalar(10, 20, 200)));
  picture.equal_aspect = true;
  picture.scales = false;
  Figure figure;
  figure.width = 400;
  figure.height = 400;
  figure.columns = 2;
  figure.panels = {wide, picture, picture};
  return figure;
}

TEST(Svg, FigureWithPicturesIsAsEver) {
  const auto golden = std::filesystem::path(CVO_SLAM_SOURCE_DIR) / "tests/plot/golden/pictures.svg";
  // The bytes of the PNG inside depend on the version of zlib.
  const auto without_images = [](std::string svg) {
    for (auto begin = svg.find("base64,"); begin != std::string::npos;
         begin = svg.find("base64,", begin + 8)) {
      svg.erase(begin + 7, svg.find('"', begin) - begin - 7);
    }
    return svg;
  };
  const auto ours = std::filesystem::path(testing::TempDir()) / "pictures.svg";
  write_file(ours, to_svg(small_figure()));
  EXPECT_EQ(without_images(read_text(ours)), without_images(read_text(golden)))
      << "if the new picture is meant: cp " << ours << " " << golden;
}

TEST(Svg, HoldsItsPicturesAsPng) {
  // The signature of PNG in base64.
  EXPECT_THAT(to_svg(small_figure()), HasSubstr("base64,iVBORw0KGgo"));
  Figure figure = small_figure();
  figure.panels.resize(1);
  EXPECT_THAT(to_svg(figure), Not(HasSubstr("xlink")));
}

TEST(Png, DrawsAPictureWithItsProportions) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.png";
  write_file(file, to_png(small_figure()));
  const cv::Mat image = cv::imread(file);
  cv::Mat is_red;
  cv::inRange(image, cv::Scalar(10, 20, 200), cv::Scalar(10, 20, 200), is_red);
  const cv::Rect left = cv::boundingRect(is_red(cv::Rect(0, 0, 200, 400)));
  EXPECT_GT(left.width, 140);
  EXPECT_NEAR(left.width, 2 * left.height, 4);  // the frame covers a pixel on each side
}

TEST(Figure, AWidePanelTakesItsColumns) {
  const std::string svg = to_svg(small_figure());
  // The lower row is that of the two pictures: their titles are on one line, at a quarter and at
  // three quarters of the width.
  EXPECT_THAT(svg, HasSubstr("<text x=\"116\""));
  EXPECT_THAT(svg, HasSubstr("<text x=\"306\""));
}

TEST(Figure, RejectsImpossibleImages) {
  Figure figure = small_figure();
  figure.panels[1].image->pixels = cv::Mat(2, 2, CV_8UC1);
  EXPECT_THROW(static_cast<void>(to_svg(figure)), OptionError);
  figure.panels[1].image->pixels = cv::Mat();
  EXPECT_THROW(static_cast<void>(to_svg(figure)), OptionError);
  figure = small_figure();
  figure.panels[1].image->x_max = figure.panels[1].image->x_min;
  EXPECT_THROW(static_cast<void>(to_png(figure)), OptionError);
}

}  // namespace
}  // namespace cvo_slam
