// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The errors of a generated trajectory against figures that an independent script computed
// (tests/reference/make_trajectories.py).
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "cvo_slam/core/files.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/trajectory_files.h"

namespace cvo_slam {
namespace {

std::filesystem::path reference_file(const char* name) {
  return std::filesystem::path(CVO_SLAM_SOURCE_DIR) / "tests" / "reference" / name;
}

/// Associations by the name that the script gives them.
std::vector<MatchedPose> matches(const std::string& association) {
  static const auto reference = read_tum(reference_file("reference.txt"));
  static const auto estimate = read_tum(reference_file("estimate.txt"));
  // NOLINTNEXTLINE(readability-suspicious-call-argument): that is what the name says
  if (association == "swapped") return associate(estimate, reference);
  const std::map<std::string, AssociationOptions> options = {
      {"nearest", {}},
      {"tight", {.max_difference = 0.007}},
      {"offset", {.time_offset = 0.004}},
      {"interpolated", {.interpolate = true}}};
  return associate(reference, estimate, options.at(association));
}

/// Rounding differs between the two programs: positions of a few metres have 16 digits, and the
/// smallest errors are millimetres.
constexpr double kRelative = 1e-9;

double next_number(std::istream& words) {
  double value = NAN;
  words >> value;
  return value;
}

void expect_next(std::istream& words, double ours, const char* what) {
  const double expected = next_number(words);
  EXPECT_NEAR(ours, expected, kRelative * std::fabs(expected)) << what;
}

void expect_next(std::istream& words, const PoseErrorStatistics& ours) {
  ASSERT_EQ(static_cast<double>(ours.translation.count), next_number(words));
  for (const Statistics* s : {&ours.translation, &ours.rotation}) {
    expect_next(words, s->rmse, "rmse");
    expect_next(words, s->mean, "mean");
    expect_next(words, s->median, "median");
    expect_next(words, s->std, "std");
    expect_next(words, s->min, "min");
    expect_next(words, s->max, "max");
  }
}

void check_ate(std::istream& words) {
  std::string association;
  std::string alignment;
  words >> association >> alignment;
  const std::map<std::string, Alignment> alignments = {
      {"none", Alignment::kNone}, {"se3", Alignment::kSe3}, {"sim3", Alignment::kSim3}};
  const auto ate = absolute_trajectory_error(matches(association), alignments.at(alignment));
  expect_next(words, ate.alignment.scale, "scale");
  expect_next(words, ate.statistics);
}

void check_rpe(std::istream& words) {
  std::string association;
  std::string unit;
  std::string pairs;
  std::string kind;
  RelativePoseOptions options;
  words >> association >> options.delta >> unit >> pairs >> kind;
  const std::map<std::string, DeltaUnit> units = {
      {"frames", DeltaUnit::kFrames}, {"m", DeltaUnit::kMetres}, {"s", DeltaUnit::kSeconds}};
  options.unit = units.at(unit);
  options.all_pairs = pairs == "all";
  options.kind = kind == "paper" ? RelativeErrorKind::kCvoPaper : RelativeErrorKind::kRelativePose;
  expect_next(words, relative_pose_error(matches(association), options).statistics);
}

TEST(ReferenceFigures, EveryLineIsReproduced) {
  std::istringstream file(read_file(reference_file("trajectory_errors.txt")));
  std::map<std::string, int> lines;
  for (std::string text; std::getline(file, text);) {
    SCOPED_TRACE(text);
    std::istringstream words(text);
    std::string measure;
    words >> measure;
    if (measure == "#") continue;
    ++lines[measure];
    if (measure == "ate") check_ate(words);
    if (measure == "rpe") check_rpe(words);
    EXPECT_FALSE(words.fail()) << "too few values";
  }
  EXPECT_EQ(lines["ate"], 5 * 3);          // associations and alignments
  EXPECT_EQ(lines["rpe"], 2 * 4 * 2 * 2);  // associations, deltas, choices of pairs, kinds
}

}  // namespace
}  // namespace cvo_slam
