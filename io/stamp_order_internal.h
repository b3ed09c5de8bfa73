// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace cvo_slam {

/// Sorts records by their member `stamp` and drops the later ones of equal stamps; says in `notes`
/// what it had to do to `file`.
template <typename Record>
void repair_stamp_order(std::vector<Record>& records, const std::string& file,
                        std::vector<std::string>& notes) {
  const auto before = [](const Record& a, const Record& b) { return a.stamp < b.stamp; };
  if (!std::is_sorted(records.begin(), records.end(), before)) {
    std::stable_sort(records.begin(), records.end(), before);
    notes.push_back(fmt::format("{}: stamps out of order; sorted", file));
  }
  const auto same = [](const Record& a, const Record& b) { return a.stamp == b.stamp; };
  const auto end = std::unique(records.begin(), records.end(), same);
  if (end == records.end()) return;
  notes.push_back(fmt::format("{}: {} duplicated stamps; the later lines are dropped", file,
                              records.end() - end));
  records.erase(end, records.end());
}

}  // namespace cvo_slam
