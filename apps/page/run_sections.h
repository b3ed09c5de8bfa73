// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parts of a run's page, as HTML.
#pragma once

#include <filesystem>
#include <string>

#include "cvo_slam/apps/page/run_page.h"

namespace cvo_slam {

/// The figures that one looks for first. Without times, which are in the section on cost.
[[nodiscard]] std::string headline(const RunReport& report);

/// What the user should know of the run; empty where there is nothing.
[[nodiscard]] std::string notes_section(const RunReport& report);

/// The map and the path.
[[nodiscard]] std::string map_section(const RunReport& report, const RunPictures& pictures);

/// Errors against the ground truth.
[[nodiscard]] std::string accuracy_section(const RunReport& report, const RunPictures& pictures);

/// How tracking went, and where and why it was lost.
[[nodiscard]] std::string tracking_section(const RunReport& report);

/// What the graph is made of and what became of its candidates; empty without one.
[[nodiscard]] std::string graph_section(const RunReport& report);

/// The pictures of recognised places; empty where none were looked for.
[[nodiscard]] std::string loops_section(const RunReport& report, const RunPictures& pictures);

/// Times and memory.
[[nodiscard]] std::string cost_section(const RunReport& report);

/// The options, those first that are not the defaults.
[[nodiscard]] std::string options_section(const RunReport& report);

/// Links to the other files in the folder.
[[nodiscard]] std::string files_section(const std::filesystem::path& folder);

/// A length for people: "12.3 mm" below a metre, else "4.49 m".
[[nodiscard]] std::string length_text(double metres);

/// The figure as part of the page: by its lines or, where these are too many, as an image.
[[nodiscard]] std::string plot(const Figure& figure, const std::string& caption);

}  // namespace cvo_slam
