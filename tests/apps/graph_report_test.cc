// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/graph_report.h"

#include <gtest/gtest.h>

namespace cvo_slam {
namespace {

/// Returns the row of one candidate.
std::string row_of(const LoopCandidate& candidate) {
  const std::string csv = loops_csv({candidate});
  return csv.substr(csv.find('\n') + 1);
}

TEST(LoopsCsv, FiguresThatWereNotTakenAreEmpty) {
  LoopCandidate c;
  c.kind = EdgeKind::kLoop;
  c.from = 3;
  c.to = 40;
  c.score = 0.0625;
  c.normalized_score = 0.5;
  c.inliers = 7;
  c.reason = "7 inliers of 30 matches; 25 needed";
  EXPECT_EQ(row_of(c),
            "bow,3,40,0.0625,0.500,7,,,,,,,,,rejected,\"7 inliers of 30 matches; 25 needed\"\n");
  c.relocalization = true;
  EXPECT_EQ(row_of(c).substr(0, 5), "lost,");
}

TEST(LoopsCsv, AnAcceptedProximityHasNoFiguresOfRecognition) {
  LoopCandidate c;
  c.from = 1;
  c.to = 2;
  c.expected_overlap = 0.75;
  c.overlap = 0.5;
  c.cos_theta = 0.25;
  c.round_trip_translation = 0.001;
  c.round_trip_rotation = 0.002;
  c.correction_translation = 0.003;
  c.correction_rotation = 0.004;
  c.error = 1.5;
  c.accepted = true;
  EXPECT_EQ(row_of(c),
            "proximity,1,2,,,,0.75,0.5000,0.2500,0.00100,0.00200,0.00300,0.00400,1.500,accepted,"
            "\"\"\n");
}

TEST(LoopsCsv, QuotesInReasonsAreDoubled) {
  LoopCandidate c;
  c.reason = "a \"b\", c";
  const std::string row = row_of(c);
  EXPECT_EQ(row.substr(row.find("rejected")), "rejected,\"a \"\"b\"\", c\"\n");
}

}  // namespace
}  // namespace cvo_slam
