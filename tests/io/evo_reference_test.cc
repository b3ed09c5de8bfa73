// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The metrics against figures that evo (github.com/MichaelGrupp/evo) computed on real trajectories.
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/tests/test_data.h"

namespace cvo_slam {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// One line of EVO_REFERENCE.txt: "file key=value ... trans key=value ... rot_deg key=value ...".
struct EvoLine {
  std::string estimate;
  std::map<std::string, std::string> settings;  ///< the words before the figures
  std::map<std::string, double> translation;    ///< [m]
  std::map<std::string, double> rotation;       ///< [deg]
};

EvoLine parse_line(const std::string& text) {
  EvoLine line;
  std::istringstream words(text);
  words >> line.estimate;
  std::map<std::string, double>* figures = nullptr;
  std::string previous;
  for (std::string word; words >> word; previous = word) {
    if (word == "trans") figures = &line.translation;
    if (word == "rot_deg") figures = &line.rotation;
    const auto equals = word.find('=');
    if (equals == std::string::npos) {
      // The unit follows "delta=1".
      if (previous.starts_with("delta=")) line.settings["unit"] = word;
      continue;
    }
    const std::string key = word.substr(0, equals);
    const std::string value = word.substr(equals + 1);
    if (figures == nullptr) {
      line.settings[key] = value;
    } else {
      (*figures)[key] = std::stod(value);
    }
  }
  return line;
}

/// Returns the file of the true poses, which is in the folder of the estimates.
std::filesystem::path reference_of(const std::string& estimate) {
  return estimate.starts_with("fr2_desk") ? "fr2_desk_groundtruth.txt"
                                          : "freiburg1_xyz-groundtruth.txt";
}

std::vector<MatchedPose> read_matches(const std::string& estimate, double max_difference) {
  const auto folder = test_data() / "trajectories";
  return associate(read_tum(folder / reference_of(estimate)), read_tum(folder / estimate),
                   {.max_difference = max_difference});
}

/// Compares every figure of the line and returns their number.
int expect_figures(const Statistics& ours, const std::map<std::string, double>& evo) {
  const std::map<std::string, double> by_name = {
      {"rmse", ours.rmse},     {"mean", ours.mean},
      {"median", ours.median}, {"std", ours.std},
      {"min", ours.min},       {"max", ours.max},
      {"sse", ours.sse},       {"n", static_cast<double>(ours.count)}};
  for (const auto& [name, value] : evo) {
    // The bound the project promises; the file has nine decimals.
    EXPECT_NEAR(by_name.at(name), value, 1e-6) << name;
  }
  return static_cast<int>(evo.size());
}

int check_ate(const EvoLine& line, const std::vector<MatchedPose>& matches) {
  const std::map<std::string, Alignment> alignments = {
      {"none", Alignment::kNone}, {"se3", Alignment::kSe3}, {"sim3", Alignment::kSim3}};
  const auto ate = absolute_trajectory_error(matches, alignments.at(line.settings.at("align")));
  EXPECT_EQ(std::to_string(matches.size()), line.settings.at("n"));
  EXPECT_NEAR(ate.alignment.scale, std::stod(line.settings.at("scale")), 1e-6);
  return 2 + expect_figures(ate.statistics.translation, line.translation) +
         expect_figures(in_unit(ate.statistics.rotation, kDegrees), line.rotation);
}

int check_rpe(const EvoLine& line, const std::vector<MatchedPose>& matches) {
  const auto rpe = relative_pose_error(
      matches, {.delta = std::stod(line.settings.at("delta")),
                .unit = line.settings.at("unit") == "m" ? DeltaUnit::kMetres : DeltaUnit::kFrames,
                .all_pairs = line.settings.at("all_pairs") == "True"});
  return expect_figures(rpe.statistics.translation, line.translation) +
         expect_figures(in_unit(rpe.statistics.rotation, kDegrees), line.rotation);
}

TEST(EvoReference, EveryFigureOfEveryLineIsReproduced) {
  CVO_SLAM_REQUIRE_DATA("trajectories/EVO_REFERENCE.txt");
  std::ifstream file(test_data() / "trajectories" / "EVO_REFERENCE.txt");
  int lines = 0;
  int figures = 0;
  for (std::string text; std::getline(file, text); ++lines) {
    SCOPED_TRACE(text);
    const EvoLine line = parse_line(text);
    const auto matches = read_matches(line.estimate, std::stod(line.settings.at("max_diff")));
    figures +=
        line.settings.contains("align") ? check_ate(line, matches) : check_rpe(line, matches);
  }
  EXPECT_EQ(lines, 66);
  // 18 ATE lines (n, scale, seven of the translation, one of the rotation), 48 RPE lines of five.
  EXPECT_EQ(figures, 18 * 10 + 48 * 5);
}

TEST(TumMetric, ReproducesThePublishedFiguresOverOneSecond) {
  CVO_SLAM_REQUIRE_DATA("trajectories/fr2_desk_ORB.txt");
  struct Case {
    const char* estimate;
    double translation_mm;
    double rotation_deg;
  };
  // Given to five digits: half a unit of the last one.
  for (const auto& expected : {Case{"freiburg1_xyz-rgbdslam.txt", 21.630, 0.93899},
                               Case{"fr2_desk_ORB.txt", 7.2891, 0.46366}}) {
    const auto rpe = relative_pose_error(read_matches(expected.estimate, 0.02));
    EXPECT_NEAR(rpe.statistics.translation.rmse * 1000, expected.translation_mm, 5e-4);
    EXPECT_NEAR(rpe.statistics.rotation.rmse * kDegrees, expected.rotation_deg, 5e-6);
  }
}

}  // namespace
}  // namespace cvo_slam
