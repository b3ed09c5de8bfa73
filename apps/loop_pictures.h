// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/loop_candidate.h"

namespace cvo_slam {

/// Of which recognised places pictures are made.
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
