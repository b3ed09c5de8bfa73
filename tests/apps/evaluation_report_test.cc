// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/evaluation_report.h"

#include <cmath>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/apps/report_json.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/core/trajectory_samples.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

TEST(EvaluationReport, HasDriftOverASecondAndFrameToFrameByDefault) {
  const auto poses = helix(40);
  const auto report = evaluate(poses, poses);
  EXPECT_EQ(report.matches, 40U);
  EXPECT_DOUBLE_EQ(report.coverage, 1);
  ASSERT_EQ(report.relative.size(), 2U);
  EXPECT_EQ(label_of(report.relative[0].options), "RPE 1 s");
  EXPECT_EQ(label_of(report.relative[1].options), "RPE 1 frame");
  EXPECT_EQ(report.relative[0].error->errors.size(), 30U);
  EXPECT_EQ(report.relative[1].error->errors.size(), 39U);
  EXPECT_TRUE(report.notes.empty());
}

TEST(EvaluationReport, CoverageIsTheMatchedShare) {
  auto reference = helix(40);
  reference.resize(10);
  // The estimate goes on after the end of the reference, which has fewer poses: all of them match.
  EXPECT_DOUBLE_EQ(evaluate(reference, helix(40)).coverage, 1);
  EXPECT_THAT(to_table(evaluate(reference, helix(40))),
              HasSubstr("matched    10 of 40 poses (100.0 % of the reference) with 10 of"));
  EXPECT_DOUBLE_EQ(evaluate(reference, helix(40), {.association = {.interpolate = true}}).coverage,
                   0.25);
}

TEST(EvaluationReport, CountsWhatIsInNoFigure) {
  auto reference = helix(40);
  reference.resize(10);
  const auto report = evaluate(
      reference, helix(40), {},
      {.reference = {.repeated = 2, .invalid = 1}, .estimate = {.repeated = 0, .invalid = 10}});
  EXPECT_EQ(report.reference_poses, 13U);
  EXPECT_EQ(report.estimate_poses, 50U);
  EXPECT_EQ(report.matches, 10U);
  EXPECT_EQ(report.unmatched, 30U);
  EXPECT_DOUBLE_EQ(report.coverage, 10.0 / 13);
  EXPECT_THAT(report.warnings,
              testing::ElementsAre(HasSubstr("3 of the 13 poses of the reference are left out"),
                                   HasSubstr("10 of the 50 poses of the estimate are left out; 10 "
                                             "are not finite")));
  EXPECT_THAT(to_table(report), HasSubstr("left out   30 poses of the estimate: no pose of the"));
}

TEST(EvaluationReport, WarnsIfManyPosesHaveNoPartner) {
  auto reference = helix(40);
  reference.resize(30);
  const auto report = evaluate(reference, helix(40), {.association = {.interpolate = true}});
  EXPECT_THAT(report.warnings, testing::ElementsAre(HasSubstr("10 of 40 poses have no partner")));
  EXPECT_THAT(to_table(report), HasSubstr("\nwarning: 10 of 40 poses have no partner"));
}

// Errors of 1e5 m and more filled the columns, and the numbers ran together.
TEST(EvaluationReport, ColumnsNeverRunTogether) {
  for (const double size : {1.0, 1e4, 1e5, 1e9, 1e40}) {
    auto estimate = helix(40);
    for (std::size_t i = 0; i < estimate.size(); ++i) {
      const SE3& pose = estimate[i].T_world_camera;
      estimate[i].T_world_camera =
          SE3(pose.rotation(), (i % 2 == 0 ? size : -size) * pose.translation());
    }
    const std::string table =
        to_table(evaluate(helix(40), estimate, {.alignment = Alignment::kNone}));
    std::istringstream lines(table.substr(table.find("ATE")));
    for (std::string line; std::getline(lines, line);) {
      const auto unit = line.find(']');
      ASSERT_NE(unit, std::string::npos);
      std::istringstream rest(line.substr(unit + 1));
      const std::vector<std::string> words{std::istream_iterator<std::string>(rest), {}};
      EXPECT_EQ(words.size(), 8U) << line;
    }
  }
}

TEST(EvaluationReport, SimilarityScalesTheRelativeErrorToo) {
  const auto truth = helix(40);
  const auto estimate = transformed({SE3(), 3.0}, truth);
  const auto report = evaluate(truth, estimate, {.alignment = Alignment::kSim3});
  EXPECT_NEAR(report.ate->alignment.scale, 1.0 / 3, 1e-12);
  EXPECT_LT(report.relative[0].error->statistics.translation.max, 1e-12);
}

TEST(EvaluationReport, WarnsIfTheEstimateIsOfAnotherSize) {
  const auto truth = helix(40);
  const auto report = evaluate(truth, transformed({SE3(), 5.0}, truth));
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_THAT(report.warnings[0], HasSubstr("the reference is 0.20 times as large"));
  EXPECT_TRUE(evaluate(truth, transformed({SE3(), 1.1}, truth)).warnings.empty());
  // A camera that stands still: noise fits best if it shrinks to nothing.
  auto still = truth;
  auto noisy = truth;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto wave = [&](double frequency, double size) {
      const double t = frequency * static_cast<double>(i);
      return Vector3(size * std::sin(t), size * std::sin(1.7 * t), size * std::cos(2.3 * t));
    };
    still[i].T_world_camera = SE3(Matrix3::Identity(), wave(1.1, 0.0003));
    noisy[i].T_world_camera = SE3(Matrix3::Identity(), wave(2.9, 0.003));
  }
  EXPECT_TRUE(evaluate(still, noisy).warnings.empty());
}

TEST(EvaluationReport, LeavesOutWhatDoesNotExistAndSaysWhy) {
  // Half a second on a straight line has no unique alignment and no pair that is a second apart.
  const auto report = evaluate(line(5), line(5));
  EXPECT_FALSE(report.ate);
  EXPECT_FALSE(report.relative[0].error);
  EXPECT_TRUE(report.relative[1].error);
  EXPECT_THAT(report.notes, testing::ElementsAre(HasSubstr("no ATE: "), HasSubstr("no RPE 1 s: ")));
  const auto json = nlohmann::json::parse(json_text(report));
  EXPECT_TRUE(json["ate"].is_null());
  EXPECT_TRUE(json["rpe"][0]["error"].is_null());
  EXPECT_EQ(json["notes"].size(), 2U);
  EXPECT_THAT(to_table(report), HasSubstr("no RPE 1 s: "));
}

TEST(EvaluationReport, ThrowsWhereNoFigureExists) {
  EXPECT_THROW(static_cast<void>(evaluate(line(1), line(1))), DataError);
  EXPECT_THROW(static_cast<void>(evaluate({}, {})), DataError);
}

TEST(EvaluationReport, JsonHasUnitsInItsKeys) {
  const auto truth = line(3);
  auto estimate = line(3);
  estimate[1].T_world_camera = SE3(so3_exp({0, 0, 1}), {1, 2, 0});
  const auto json =
      nlohmann::json::parse(json_text(evaluate(truth, estimate, {.alignment = Alignment::kNone})));
  EXPECT_DOUBLE_EQ(json["ate"]["translation_m"]["max"].get<double>(), 2);
  // The estimate is turned by one radian.
  EXPECT_NEAR(json["ate"]["rotation_deg"]["max"].get<double>(), 57.29577951308232, 1e-12);
  EXPECT_EQ(json["rpe"][1]["unit"], "frames");
  EXPECT_EQ(json["alignment"], "none");
}

}  // namespace
}  // namespace cvo_slam
