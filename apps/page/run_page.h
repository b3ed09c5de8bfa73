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

/// What a run's page has to show.
struct RunPictures {
  std::vector<NamedFigure> figures;
  cv::Mat map;  ///< empty where there is none
  LoopGallery loops;
};

/// How many pairs of images a page has at most: some 2 MB.
inline constexpr std::size_t kMostLoopsOnPage = 24;

/// The page of a run, one file that needs no other and no network, to be report.html in `folder`;
/// it has links to the run's other files that are there. Two runs with the same results have the
/// same page but for the section "cost".
[[nodiscard]] std::string run_page(const std::filesystem::path& folder, const RunReport& report,
                                   const RunPictures& pictures);

}  // namespace cvo_slam
