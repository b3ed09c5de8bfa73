// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/apps/evaluation_plots.h"
#include "cvo_slam/apps/loop_pictures.h"
#include "cvo_slam/apps/run_report.h"

namespace cvo_slam {

/// The pictures of the page of a run.
struct RunPictures {
  std::vector<NamedFigure> figures;
  cv::Mat map;  ///< empty if there is none
  LoopGallery loops;
};

/// Largest number of loop pictures on a page, about 2 MB.
inline constexpr std::size_t kMostLoopsOnPage = 24;

/// Returns the page of a run, which is to be report.html in `folder`: one file that needs no other
/// file and no network. It has links to the other files of the run that exist. Two runs with the
/// same results have the same page except for the section "cost".
[[nodiscard]] std::string run_page(const std::filesystem::path& folder, const RunReport& report,
                                   const RunPictures& pictures);

}  // namespace cvo_slam
