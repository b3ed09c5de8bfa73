// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/page/reasons.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "cvo_slam/apps/graph_report.h"

namespace cvo_slam {
namespace {

/// Adds a lost frame to the last span if the reasons differ only in their figures. Returns true if
/// it did.
bool extend(std::vector<LostSpan>& spans, std::size_t frame, const LostFrame& lost) {
  LostSpan& span = spans.back();
  const std::string kind = without_figures(lost.reason);
  if (without_figures(span.reason) != kind) return false;
  if (span.reason != lost.reason) span.reason = kind;
  span.last = frame;
  ++span.count;
  return true;
}

}  // namespace

std::string without_figures(std::string_view reason) {
  constexpr std::string_view kDigits = "0123456789";
  std::string text;
  for (std::size_t i = 0; i < reason.size();) {
    const std::size_t first = reason[i] == '-' ? i + 1 : i;
    std::size_t end = std::min(reason.find_first_not_of(kDigits, first), reason.size());
    if (end == first) {
      text += reason[i++];
      continue;
    }
    // A point or an exponent belongs to the number if a digit follows.
    for (const std::string_view mark : {".", "e-", "e"}) {
      while (reason.substr(end).starts_with(mark)) {
        const std::size_t digits = end + mark.size();
        const std::size_t next = std::min(reason.find_first_not_of(kDigits, digits), reason.size());
        if (next == digits) break;
        end = next;
      }
    }
    text += "\xE2\x80\xA6";  // "…"
    i = end;
  }
  return text;
}

std::vector<LostSpan> lost_spans(const std::vector<FrameRecord>& records,
                                 const std::vector<LostFrame>& lost) {
  std::vector<LostSpan> spans;
  auto next = lost.begin();
  bool goes_on = false;
  for (const FrameRecord& record : records) {
    if (next == lost.end() || next->stamp != record.stamp) {
      goes_on = false;
      continue;
    }
    if (!goes_on || !extend(spans, record.index, *next)) {
      spans.push_back({record.index, record.index, record.stamp, 1, next->reason, next->reason});
    }
    goes_on = true;
    ++next;
  }
  return spans;
}

std::vector<VerdictCount> count_verdicts(const std::vector<LoopCandidate>& candidates) {
  std::map<std::string_view, VerdictCount> counts;
  for (const LoopCandidate& candidate : candidates) {
    VerdictCount& count = counts[name_of(candidate)];
    ++(candidate.accepted ? count.accepted : count.rejected);
  }
  std::vector<VerdictCount> result;
  result.reserve(counts.size());
  for (auto& [name, count] : counts) {
    count.found_by = name;
    result.push_back(count);
  }
  return result;
}

std::vector<ReasonCount> count_reasons(const std::vector<LoopCandidate>& candidates) {
  std::map<std::pair<std::string_view, std::string>, std::size_t> counts;
  for (const LoopCandidate& candidate : candidates) {
    if (candidate.accepted) continue;
    ++counts[{name_of(candidate), without_figures(candidate.reason)}];
  }
  std::vector<ReasonCount> result;
  result.reserve(counts.size());
  for (const auto& [key, count] : counts) {
    result.push_back({std::string(key.first), key.second, count});
  }
  std::stable_sort(result.begin(), result.end(), [](const ReasonCount& a, const ReasonCount& b) {
    return std::tie(a.found_by, b.count) < std::tie(b.found_by, a.count);
  });
  return result;
}

}  // namespace cvo_slam
