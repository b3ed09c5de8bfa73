// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cvo_slam/apps/sequence_run.h"

namespace cvo_slam {

/// A text as a field of a CSV file.
[[nodiscard]] std::string csv_quoted(const std::string& text);

/// How a candidate was found: "proximity" or, by a bag of words, "bow".
[[nodiscard]] std::string_view name_of(const LoopCandidate& candidate);

[[nodiscard]] std::size_t edges_of_kind(const PoseGraph& graph, EdgeKind kind);

/// Its rows in the table at the end of a run.
[[nodiscard]] std::string to_table(const GraphResult& result);

/// One line a candidate.
[[nodiscard]] std::string loops_csv(const std::vector<LoopCandidate>& candidates);

/// Writes loops.csv. Throws OutputError.
void write_loops(const std::filesystem::path& folder, const GraphResult& result);

}  // namespace cvo_slam
