// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "cvo_slam/apps/page/html.h"
#include "cvo_slam/apps/page/reasons.h"
#include "cvo_slam/apps/page/run_sections.h"

namespace cvo_slam {
namespace {

using html::Cell;

constexpr std::size_t kMostRows = 100;

/// A figure of each registration over time; lines are broken where there was none.
Series over_time(const std::vector<FrameRecord>& records, double RegistrationResult::*value) {
  Series series;
  series.width = 1.2;
  for (const FrameRecord& record : records) {
    const bool registered = record.status == TrackingStatus::kTracked &&
                            record.registration.status != RegistrationStatus::kFailed;
    series.x.push_back(seconds_between(records.front().stamp, record.stamp));
    series.y.push_back(registered ? record.registration.*value
                                  : std::numeric_limits<double>::quiet_NaN());
  }
  return series;
}

Series lost_frames(const std::vector<FrameRecord>& records) {
  Series series{"lost", {}, {}, kVermilion, SeriesStyle::kPoints, 3};
  for (const FrameRecord& record : records) {
    if (record.status == TrackingStatus::kTracked) continue;
    series.x.push_back(seconds_between(records.front().stamp, record.stamp));
    series.y.push_back(0);
  }
  return series;
}

Figure tracking_figure(const std::vector<FrameRecord>& records) {
  Figure figure;
  figure.columns = 2;
  figure.width = 1500;
  figure.height = 300;
  const auto add = [&](const char* title, const char* label, double RegistrationResult::*value) {
    Panel panel{title, "time [s]", label, {over_time(records, value)}, false, true};
    Series lost = lost_frames(records);
    if (!lost.x.empty()) panel.series.push_back(std::move(lost));
    figure.panels.push_back(std::move(panel));
  };
  add("Overlap with the keyframe", "share of points", &RegistrationResult::overlap);
  add("Likeness of the two clouds", "cos_theta", &RegistrationResult::cos_theta);
  return figure;
}

std::string frames_text(const LostSpan& span) {
  return span.first == span.last ? fmt::to_string(span.first)
                                 : fmt::format("{} to {}", span.first, span.last);
}

std::string lost_table(const RunReport& report) {
  const auto spans = lost_spans(report.run.records, report.trajectory.lost);
  if (spans.empty()) return html::paragraph("No frame was lost.");
  html::Table table({{"frames"}, {"from [s]"}, {"how many", Cell::kNumber}, {"why"}});
  for (std::size_t i = 0; i < std::min(spans.size(), kMostRows); ++i) {
    table.add({frames_text(spans[i]), spans[i].stamp.to_string(), fmt::to_string(spans[i].count),
               spans[i].reason});
  }
  std::string content = html::element("h3", "Lost frames") + table.content();
  if (spans.size() > kMostRows) {
    content += html::paragraph(
        fmt::format("{} more such stretches are in frames.csv.", spans.size() - kMostRows));
  }
  return content;
}

}  // namespace

std::string tracking_section(const RunReport& report) {
  std::string content;
  if (!report.run.records.empty()) {
    content += plot(tracking_figure(report.run.records),
                    "Each frame's registration to its keyframe. The overlap falls while the camera "
                    "leaves a keyframe behind, and jumps where a new one is made.");
  }
  return html::section("tracking", "Tracking", content + lost_table(report));
}

}  // namespace cvo_slam
