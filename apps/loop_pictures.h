// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/io/dataset.h"
#include "cvo_slam/loop/loop_verifier.h"
#include "cvo_slam/slam/loop_candidate.h"

namespace cvo_slam {

/// Draws two images side by side, with a line from each point to its match in the other image. The
/// images are CV_8UC3 or CV_8UC1, of any size; a grey field takes the place of an empty one.
/// Returns a picture in CV_8UC3 (blue, green, red), shrunk to `max_width` [px] if it is wider.
[[nodiscard]] cv::Mat draw_matches(const cv::Mat& a, const cv::Mat& b,
                                   const std::vector<PixelPair>& pixels, int max_width);

/// The loop candidates whose pictures are drawn.
enum class LoopPictures { kNone, kAccepted, kAll };

/// A loop candidate with its picture.
struct PicturedLoop {
  LoopCandidate candidate;
  std::string jpeg;  ///< bytes of a small JPEG file
};

/// The loop pictures of a run.
struct LoopGallery {
  std::size_t files = 0;             ///< number of files that were written
  std::vector<PicturedLoop> chosen;  ///< pictures for the page, in the order of the frames
};

/// Writes the two images of each candidate side by side, with their inlier matches, as
/// loops/<verdict>_<from>_<to>.png. Candidates by proximity have no picture, because their images
/// were not matched. The page gets at most `max_chosen`: first the accepted candidates that
/// corrected the graph most, then rejected ones. Adds a line to `notes` for an image that cannot be
/// read. Throws OutputError.
[[nodiscard]] LoopGallery write_loop_pictures(const std::filesystem::path& folder,
                                              const Dataset& data,
                                              const std::vector<LoopCandidate>& candidates,
                                              LoopPictures which, std::size_t max_chosen,
                                              std::vector<std::string>& notes);

/// Removes the files of write_loop_pictures(), and their folder unless something else is in it.
/// Throws OutputError.
void remove_loop_pictures(const std::filesystem::path& folder);

}  // namespace cvo_slam
