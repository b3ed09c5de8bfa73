// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/plot/comparison_plot.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/files.h"
#include "cvo_slam/plot/figure.h"
#include "cvo_slam/tests/core/trajectory_samples.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;

/// Errors of 1, 2, ... mm and twice as many radians/1000.
std::vector<PoseError> errors(int count, double factor = 1) {
  std::vector<PoseError> result;
  for (int i = count; i > 0; --i) result.push_back({{}, factor * 1e-3 * i, factor * 2e-3 * i});
  return result;
}

std::vector<ComparedTrajectory> two_estimates() {
  return {{"ours", line(5), errors(4)}, {"theirs", helix(5), errors(2)}};
}

TEST(ComparisonFigure, IsAsEver) {
  const auto golden =
      std::filesystem::path(CVO_SLAM_SOURCE_DIR) / "tests/plot/golden/comparison.svg";
  const auto ours = std::filesystem::path(testing::TempDir()) / "comparison.svg";
  write_file(ours, to_svg(comparison_figure(line(5), two_estimates())));
  EXPECT_EQ(read_text(ours), read_text(golden))
      << "if the new picture is meant: cp " << ours << " " << golden;
}

TEST(ComparisonFigure, DistributionsAreStairsFromZeroToOne) {
  const Figure figure = comparison_figure(line(5), two_estimates());
  const Series& series = figure.panels[0].series[0];
  EXPECT_THAT(series.x, ElementsAre(0, 1, 1, 2, 2, 3, 3, 4, 4, 4));
  EXPECT_THAT(series.y, ElementsAre(0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1));
  // Rotations in degrees.
  EXPECT_NEAR(figure.panels[1].series[0].x[1], 2e-3 * 180 / M_PI, 1e-12);
}

TEST(ComparisonFigure, AHopelessEstimateDoesNotPressTheOthersTogether) {
  auto estimates = two_estimates();
  estimates[1].errors = errors(100, 1000);
  const Figure figure = comparison_figure(line(5), estimates);
  // Four times what holds 95 % of the better one's errors: 4 mm.
  EXPECT_EQ(figure.panels[0].series[0].x.back(), 16);
  EXPECT_EQ(figure.panels[0].series[1].y.back(), 0);
}

TEST(ComparisonFigure, HasATopViewForEachEstimateInItsColour) {
  const Figure figure = comparison_figure(line(5), two_estimates());
  ASSERT_EQ(figure.panels.size(), 4U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Panel& view = figure.panels[2 + i];
    EXPECT_EQ(view.title, two_estimates()[i].name);
    EXPECT_TRUE(view.equal_aspect);
    ASSERT_EQ(view.series.size(), 2U);
    EXPECT_EQ(view.series[0].label, "ground truth");
    const Color& color = figure.panels[0].series[i].color;
    EXPECT_EQ(view.series[1].color.red, color.red);
    EXPECT_EQ(view.series[1].color.blue, color.blue);
  }
}

TEST(ComparisonFigure, EstimatesAreToldApartWithoutColour) {
  std::vector<ComparedTrajectory> estimates;
  estimates.reserve(5);
  for (int i = 0; i < 5; ++i) estimates.push_back({std::to_string(i), line(3), errors(3)});
  const Figure figure = comparison_figure(line(3), estimates);
  const auto& series = figure.panels[0].series;
  for (std::size_t i = 0; i < series.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(series[i].pattern != series[j].pattern || series[i].width != series[j].width);
    }
  }
}

TEST(ComparisonFigure, WithoutErrorsOrEstimatesSaysSo) {
  const std::vector<ComparedTrajectory> estimates = {{"ours", {}, {}}};
  EXPECT_THAT(to_svg(comparison_figure({}, estimates)), testing::HasSubstr(">no data<"));
  EXPECT_THAT(to_svg(comparison_figure({}, {})), testing::HasSubstr(">no data<"));
}

TEST(ComparisonFigure, LeavesOutErrorsThatAreNotFinite) {
  auto estimates = two_estimates();
  estimates[0].errors.push_back({{}, NAN, HUGE_VAL});
  EXPECT_EQ(comparison_figure(line(5), estimates).panels[0].series[0].y.back(), 1);
}

}  // namespace
}  // namespace cvo_slam
