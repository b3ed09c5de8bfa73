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

/// Returns a text as a quoted field of a CSV file.
[[nodiscard]] std::string csv_quoted(const std::string& text);

/// Returns how a candidate was found: "proximity", "bow" (bag of words) or "lost" (relocalisation).
[[nodiscard]] std::string_view name_of(const LoopCandidate& candidate);

/// Returns the number of edges of a kind.
[[nodiscard]] std::size_t edges_of_kind(const PoseGraph& graph, EdgeKind kind);

/// Returns the rows of the graph in the table at the end of a run.
[[nodiscard]] std::string to_table(const GraphResult& result);

/// Returns the text of loops.csv: a header, and one line for each candidate.
[[nodiscard]] std::string loops_csv(const std::vector<LoopCandidate>& candidates);

/// Writes loops.csv. Throws OutputError.
void write_loops(const std::filesystem::path& folder, const GraphResult& result);

}  // namespace cvo_slam
