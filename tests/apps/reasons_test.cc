// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/page/reasons.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cvo_slam {
namespace {

const std::string kDots = "\xE2\x80\xA6";

TEST(Reasons, LikeOnesAreTheSameWithoutTheirFigures) {
  EXPECT_EQ(without_figures("only 7 points"), "only " + kDots + " points");
  EXPECT_EQ(without_figures("overlap 0.55 is below 0.60"),
            "overlap " + kDots + " is below " + kDots);
  EXPECT_EQ(without_figures("-1.5e-7"), kDots);
  EXPECT_EQ(without_figures("joined already"), "joined already");
}

/// One frame a second, from every second image; an empty reason means tracked.
struct Frames {
  explicit Frames(const std::vector<std::string>& reasons) {
    for (std::size_t i = 0; i < reasons.size(); ++i) {
      FrameRecord record;
      record.index = 2 * i;
      record.stamp = Timestamp::from_seconds(static_cast<double>(i));
      records.push_back(record);
      if (!reasons[i].empty()) lost.push_back({record.stamp, reasons[i]});
    }
  }
  std::vector<FrameRecord> records;
  std::vector<LostFrame> lost;
};

TEST(Reasons, ConsecutiveLostFramesAreOneSpan) {
  const Frames frames({"", "only 7 points", "only 8 points", "blurred", "", "blurred", "blurred"});
  const auto spans = lost_spans(frames.records, frames.lost);
  ASSERT_EQ(spans.size(), 3U);
  EXPECT_EQ(spans[0].first, 2U);
  EXPECT_EQ(spans[0].last, 4U);
  EXPECT_EQ(spans[0].count, 2U);
  EXPECT_EQ(spans[0].reason, "only " + kDots + " points");
  EXPECT_EQ(spans[0].stamp, Timestamp::from_seconds(1));
  EXPECT_EQ(spans[1].count, 1U);
  EXPECT_EQ(spans[1].reason, "blurred");
  EXPECT_EQ(spans[2].first, 10U) << "a tracked frame is between them";
  EXPECT_EQ(spans[2].count, 2U);
}

TEST(Reasons, ASpanKeepsTheFiguresThatAllHave) {
  const Frames frames({"only 7 points", "only 7 points"});
  EXPECT_EQ(lost_spans(frames.records, frames.lost).at(0).reason, "only 7 points");
  EXPECT_TRUE(lost_spans(frames.records, {}).empty());
}

TEST(Reasons, CandidatesAreCountedByVerdictAndReason) {
  const auto candidate = [](EdgeKind kind, const std::string& reason) {
    LoopCandidate c;
    c.kind = kind;
    c.accepted = reason.empty();
    c.reason = reason;
    return c;
  };
  const std::vector<LoopCandidate> candidates = {
      candidate(EdgeKind::kProximity, "overlap 0.5"), candidate(EdgeKind::kLoop, ""),
      candidate(EdgeKind::kLoop, "3 features match"), candidate(EdgeKind::kLoop, "overlap 0.1"),
      candidate(EdgeKind::kLoop, "overlap 0.2")};
  const auto verdicts = count_verdicts(candidates);
  ASSERT_EQ(verdicts.size(), 2U);
  EXPECT_EQ(verdicts[0].found_by, "bow");
  EXPECT_EQ(verdicts[0].accepted, 1U);
  EXPECT_EQ(verdicts[0].rejected, 3U);
  EXPECT_EQ(verdicts[1].found_by, "proximity");
  const auto reasons = count_reasons(candidates);
  ASSERT_EQ(reasons.size(), 3U);
  EXPECT_EQ(reasons[0].reason, "overlap " + kDots) << "the most frequent first";
  EXPECT_EQ(reasons[0].count, 2U);
  EXPECT_EQ(reasons[1].reason, kDots + " features match");
  EXPECT_EQ(reasons[2].found_by, "proximity");
}

}  // namespace
}  // namespace cvo_slam
