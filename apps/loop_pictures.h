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

/// Two images side by side, with a line from each point to where the other image sees it. The
/// images are CV_8UC3 or CV_8UC1, of any size; in the place of an empty one there is a grey field.
/// A picture wider than `max_width` [px] is shrunk to it. CV_8UC3: blue, green, red.
[[nodiscard]] cv::Mat draw_matches(const cv::Mat& a, const cv::Mat& b,
                                   const std::vector<PixelPair>& pixels, int max_width);

/// The loop candidates whose pictures are drawn.
enum class LoopPictures { kNone, kAccepted, kAll };

/// A recognised place with its picture.
struct PicturedLoop {
  LoopCandidate candidate;
  std::string jpeg;  ///< the bytes of a small one
};

/// The pictures of a run.
struct LoopGallery {
  std::size_t files = 0;             ///< that were written
  std::vector<PicturedLoop> chosen;  ///< some of them, for a page; in the order of the frames
};

/// Writes the two images of each candidate side by side, with their inlier matches, as
/// loops/<verdict>_<from>_<to>.png. Candidates by proximity have none: nothing was matched in their
/// images. Of the accepted ones those that corrected the graph most are chosen for the page, then
/// rejected ones, at most `max_chosen` together. An image that cannot be read is said in `notes`.
/// Throws OutputError.
[[nodiscard]] LoopGallery write_loop_pictures(const std::filesystem::path& folder,
                                              const Dataset& data,
                                              const std::vector<LoopCandidate>& candidates,
                                              LoopPictures which, std::size_t max_chosen,
                                              std::vector<std::string>& notes);

/// Removes what write_loop_pictures() wrote, and its folder unless something else is in it.
/// Throws OutputError.
void remove_loop_pictures(const std::filesystem::path& folder);

}  // namespace cvo_slam
