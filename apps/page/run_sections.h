// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parts of the page of a run, as HTML.
#pragma once

#include <filesystem>
#include <string>

#include "cvo_slam/apps/page/run_page.h"

namespace cvo_slam {

/// The most important figures, in large print. Times are in the section on cost.
[[nodiscard]] std::string headline(const RunReport& report);

/// The notes on the run; empty if there is none.
[[nodiscard]] std::string notes_section(const RunReport& report);

/// The map and the path.
[[nodiscard]] std::string map_section(const RunReport& report, const RunPictures& pictures);

/// Errors against the ground truth.
[[nodiscard]] std::string accuracy_section(const RunReport& report, const RunPictures& pictures);

/// Tracking over time, and the lost frames with their reasons.
[[nodiscard]] std::string tracking_section(const RunReport& report);

/// The edges of the graph and the verdicts on its candidates; empty if there is no graph.
[[nodiscard]] std::string graph_section(const RunReport& report);

/// The pictures of loop candidates; empty if place recognition was off.
[[nodiscard]] std::string loops_section(const RunReport& report, const RunPictures& pictures);

/// Times and memory.
[[nodiscard]] std::string cost_section(const RunReport& report);

/// The options; first those that differ from the defaults.
[[nodiscard]] std::string options_section(const RunReport& report);

/// Links to the other files in the folder.
[[nodiscard]] std::string files_section(const std::filesystem::path& folder);

/// Returns a length for people: "12.3 mm" below a metre, otherwise "4.49 m".
[[nodiscard]] std::string length_text(double metres);

/// Returns a figure as part of the page: as vector graphics or, if these are too large, as an
/// image.
[[nodiscard]] std::string plot(const Figure& figure, const std::string& caption);

}  // namespace cvo_slam
