// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <regex>
#include <string>

#include <fmt/format.h>

#include "cvo_slam/tests/architecture/rules.h"

namespace cvo_slam::architecture {

/// `index` counts lines from 0.
inline std::string finding(const SourceFile& file, std::size_t index, const std::string& message) {
  return fmt::format("{}:{}: {}", file.path, index + 1, message);
}

/// A finding for each of `lines` (a view of `file`) in which `pattern` occurs.
inline Findings find_all(const SourceFile& file, const std::vector<std::string>& lines,
                         const std::regex& pattern, const std::string& advice) {
  Findings findings;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (!std::regex_search(lines[i], match, pattern)) continue;
    findings.push_back(finding(file, i, fmt::format("'{}': {}", match.str(), advice)));
  }
  return findings;
}

}  // namespace cvo_slam::architecture
