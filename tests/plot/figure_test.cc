// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/plot/figure.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/plot/panel_internal.h"
#include "cvo_slam/plot/trajectory_plot.h"
#include "cvo_slam/tests/core/trajectory_samples.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> labels(double min, double max, int steps) {
  std::vector<std::string> result;
  for (const auto& tick : make_ticks({min, max}, steps)) result.push_back(tick.label);
  return result;
}

TEST(Ticks, AreMultiplesOfOneTwoOrFive) {
  EXPECT_THAT(labels(0, 1, 5), ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(labels(0, 1, 4), ElementsAre("0.0", "0.5", "1.0"));
  EXPECT_THAT(labels(-12, 31, 5), ElementsAre("-10", "0", "10", "20", "30"));
  EXPECT_THAT(labels(0.031, 0.052, 4), ElementsAre("0.04", "0.05"));
  EXPECT_THAT(labels(0, 3e6, 3), ElementsAre("0", "1e+06", "2e+06", "3e+06"));
}

TEST(Ticks, HaveNoNegativeZero) {
  EXPECT_THAT(labels(-0.1, 0.1, 2), ElementsAre("-0.1", "0.0", "0.1"));
}

Figure small_figure() {
  Series curve;
  curve.label = "a < b & \"c\"";
  curve.x = {0, 1, 2, 3};
  curve.y = {0, 2, kNaN, 1};
  Series dots;
  dots.x = {0.5};
  dots.y = {1};
  dots.color = kVermilion;
  dots.style = SeriesStyle::kPoints;
  dots.width = 4;
  Figure figure;
  figure.title = "Title";
  figure.width = 320;
  figure.height = 240;
  figure.panels = {{"Panel", "x [m]", "y [m]", {curve, dots}}};
  return figure;
}

TEST(Svg, SmallFigureIsAsEver) {
  const auto golden = std::filesystem::path(CVO_SLAM_SOURCE_DIR) / "tests/plot/golden/figure.svg";
  const auto ours = std::filesystem::path(testing::TempDir()) / "figure.svg";
  write_file(ours, to_svg(small_figure()));
  EXPECT_EQ(read_text(ours), read_text(golden))
      << "if the new picture is meant: cp " << ours << " " << golden;
}

TEST(Svg, EscapesWhatXmlReserves) {
  EXPECT_THAT(to_svg(small_figure()), HasSubstr(">a &lt; b &amp; &quot;c&quot;<"));
  Figure figure = small_figure();
  figure.title = "bell \a";
  EXPECT_THAT(to_svg(figure), HasSubstr(">bell  <"));
}

/// Returns figures with odd data, which must nevertheless have a defined picture.
std::vector<Figure> odd_figures() {
  std::vector<Figure> figures(9, small_figure());
  const auto series = [](Figure& figure) -> Series& { return figure.panels[0].series[0]; };
  figures[0].panels.clear();
  figures[1].panels[0].series.clear();
  series(figures[2]).x = {1};
  series(figures[2]).y = {2};
  series(figures[3]).y = {kNaN, kNaN, kNaN};
  series(figures[4]).y = {1e300, -1e300, HUGE_VAL, 1};
  series(figures[5]).y = {1e12, 1e12, 1e12 - 1};
  series(figures[6]).x = {5, 5, 5, 5};
  figures[6].panels[0].equal_aspect = true;
  figures[7].width = 100;
  figures[7].height = 100;
  series(figures[8]).y = {-1e12, 1e12, 1e-12, 0};
  figures[8].panels[0].y_from_zero = true;
  return figures;
}

TEST(Plot, OddDataHaveADefinedPicture) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "odd.png";
  for (const auto& figure : odd_figures()) {
    EXPECT_THAT(to_svg(figure), Not(HasSubstr("nan\"")));
    EXPECT_THAT(to_svg(figure), Not(HasSubstr("inf")));
    write_file(file, to_png(figure));
    const cv::Mat image = cv::imread(file);
    EXPECT_EQ(image.size(), cv::Size(figure.width, figure.height));
  }
}

TEST(Plot, WithoutDataSaysSo) {
  Figure figure = small_figure();
  figure.panels[0].series.clear();
  EXPECT_THAT(to_svg(figure), HasSubstr(">no data<"));
}

TEST(Plot, RejectsImpossibleSizes) {
  Figure figure = small_figure();
  figure.width = 0;
  EXPECT_THROW(static_cast<void>(to_svg(figure)), OptionError);
  EXPECT_THROW(static_cast<void>(to_png(figure)), OptionError);
  figure = small_figure();
  figure.columns = 0;
  EXPECT_THROW(static_cast<void>(to_svg(figure)), OptionError);
}

TEST(Plot, UnwritableFilesAreErrors) {
  EXPECT_THROW(write_figure("/no/such/folder/a", small_figure()), OutputError);
}

TEST(Plot, AFigureIsWrittenInBothFormats) {
  const TemporaryFolder folder;
  write_figure(folder.path() / "rpe_1.0_s", small_figure());
  EXPECT_EQ(read_text(folder.path() / "rpe_1.0_s.svg"), to_svg(small_figure()));
  EXPECT_EQ(read_text(folder.path() / "rpe_1.0_s.png"), to_png(small_figure()));
}

TEST(Png, DrawsTheColourOfASeriesWhereItsPointIs) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.png";
  write_file(file, to_png(small_figure()));
  const cv::Mat image = cv::imread(file);
  cv::Mat is_vermilion;
  cv::inRange(image, cv::Scalar(0, 94, 213), cv::Scalar(0, 94, 213), is_vermilion);
  // A disc of radius 4 has 50 pixels, those on its rim are blended.
  EXPECT_NEAR(cv::countNonZero(is_vermilion), 40, 10);
}

/// Returns the trajectory in a world whose z is the up direction of the cameras.
std::vector<StampedPose> with_z_up(std::vector<StampedPose> poses) {
  const SE3 T_upright_world(Matrix3{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, Vector3::Zero());
  for (StampedPose& pose : poses) pose.T_world_camera = T_upright_world * pose.T_world_camera;
  return poses;
}

TEST(TrajectoryFigure, HasThreeViewsWithEqualAspect) {
  const auto path = with_z_up(helix(5));
  const Figure figure = trajectory_figure(path, path);
  ASSERT_EQ(figure.panels.size(), 3U);
  for (const auto& panel : figure.panels) {
    EXPECT_TRUE(panel.equal_aspect);
    ASSERT_EQ(panel.series.size(), 3U);
    EXPECT_EQ(panel.series[0].label, "ground truth");
    EXPECT_EQ(panel.series[1].label, "estimate");
  }
  EXPECT_EQ(figure.panels[0].y_label, "y [m]");
}

// The top view of the true poses of 7-Scenes used to be one from the front.
TEST(TrajectoryFigure, LooksFromAboveWhereTheWorldIsACameras) {
  const Figure figure = trajectory_figure(helix(5), helix(5));
  EXPECT_EQ(figure.panels[0].y_label, "z [m]");
  EXPECT_EQ(figure.panels[1].y_label, "-y [m]");
}

TEST(TrajectoryFigure, WithoutReferenceLooksFromTheFirstCamera) {
  const Figure figure = trajectory_figure({}, line(3));
  EXPECT_EQ(figure.panels[0].y_label, "z [m]");
  EXPECT_EQ(figure.panels[1].y_label, "-y [m]");
  EXPECT_THAT(figure.panels[0].series[0].x, ElementsAre(0, 1, 2));
}

// Numbers of seven digits on the axes were all the same, "5e+06".
TEST(TrajectoryFigure, FarCoordinatesAreDrawnFromAnOriginThatTheLabelsName) {
  auto path = with_z_up(line(3));
  for (auto& pose : path) {
    pose.T_world_camera = SE3(Matrix3::Identity(), {400000, 5000000, 120}) * pose.T_world_camera;
  }
  const Figure figure = trajectory_figure(path, path);
  EXPECT_EQ(figure.panels[0].x_label, "x - 400000 [m]");
  EXPECT_EQ(figure.panels[0].y_label, "y - 5000000 [m]");
  EXPECT_EQ(figure.panels[1].y_label, "z [m]");
  EXPECT_THAT(figure.panels[0].series[0].x, ElementsAre(0, 1, 2));
  EXPECT_EQ(trajectory_figure({}, path).panels[1].y_label, "-(y - 5000000) [m]");
}

TEST(TrajectoryFigure, OfNothingIsEmpty) {
  for (const auto& panel : trajectory_figure({}, {}).panels) EXPECT_TRUE(panel.series.empty());
}

TEST(TrajectoryFigure, BreaksTheLineWhereFramesAreMissing) {
  auto poses = line(4);
  poses[3].stamp = milliseconds(1000);  // 800 ms after the one before, 100 ms is usual
  const Figure figure = trajectory_figure({}, poses);
  const auto& x = figure.panels[0].series[0].x;
  ASSERT_EQ(x.size(), 5U);
  EXPECT_TRUE(std::isnan(x[3]));
}

TEST(ErrorFigure, ShowsMillimetresAndDegreesOverSeconds) {
  const Figure figure = error_figure(
      {{"ATE", {{milliseconds(5000), 0.001, 0.0}, {milliseconds(5100), 0.003, std::acos(-1.0)}}},
       {"RPE 1 s", {}}});
  ASSERT_EQ(figure.panels.size(), 4U);
  EXPECT_THAT(figure.panels[0].series[0].y, ElementsAre(1, 3));
  EXPECT_THAT(figure.panels[1].series[0].y, ElementsAre(0, 180));
  EXPECT_THAT(figure.panels[0].series[0].x, ElementsAre(0, 0.1));
  // sqrt((1 + 9) / 2)
  EXPECT_EQ(figure.panels[0].title, "ATE translation, RMSE 2.236 mm");
  EXPECT_EQ(figure.panels[0].y_label, "translation [mm]");
  EXPECT_THAT(to_svg(figure), HasSubstr(">no data<"));
}

}  // namespace
}  // namespace cvo_slam
