// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/registration_plots.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/frontend/simd.h"
#include "cvo_slam/plot/figure.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

TEST(StepFigure, ShowsTheCurveItsExpansionsAndTheirSteps) {
  const PointCloud cloud = random_cloud(200, 1);
  const StepCurve curve(cloud, cloud, motion(0.05, 0, 0, 0, 0, 0.05), {}, {}, 0.15);
  const Figure figure = step_figure(curve);
  const auto& series = figure.panels.at(0).series;
  ASSERT_EQ(series.size(), 5U);
  EXPECT_EQ(series[0].label, "exact");
  EXPECT_EQ(series[1].label, "2nd order");
  EXPECT_EQ(series[2].label, "4th order");
  // In the unit of the label, a power of ten, the longer step is between 1 and 10.
  const double longest = std::max(series[3].x[0], series[4].x[0]);
  EXPECT_GE(longest, 1);
  EXPECT_LT(longest, 10);
  EXPECT_EQ(series[4].y[0], curve.exact(curve.step(4)));
  // The expansions can be told apart in grey print, too.
  EXPECT_NE(series[1].pattern, series[2].pattern);
}

TEST(StepFigure, WithoutASlopeSaysSo) {
  const StepCurve curve({}, {}, SE3(), {}, {}, 0.15);
  EXPECT_THAT(to_svg(step_figure(curve)), testing::HasSubstr(">no data<"));
}

}  // namespace
}  // namespace cvo_slam
