// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lists of image files with their stamps, the layout of TUM RGB-D, which other data sets share:
// rgb.txt and depth.txt, or a file that lists pairs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/io/dataset/formats_internal.h"

namespace cvo_slam {

/// Returns the pairs (index in a, index in b) of stamps that differ by at most `max_difference`
/// [s]. The closest pair of all is taken first, then the closest of the remaining stamps, and so
/// on; no stamp is in two pairs. Of equal differences the first in a, then in b, is taken. Both
/// lists and the result are in ascending order.
std::vector<std::pair<std::size_t, std::size_t>> associate_stamps(const std::vector<Timestamp>& a,
                                                                  const std::vector<Timestamp>& b,
                                                                  double max_difference);

/// An image and when it was taken.
struct StampedFile {
  Timestamp stamp;
  std::filesystem::path file;
};

/// Returns true if a name ends like that of an image.
bool has_image_extension(std::string_view name);

/// Returns the frames that colour and depth images make, both in ascending order of stamps; the
/// depth offset was not added yet.
Sequence pair_images(const std::vector<StampedFile>& colors, const std::vector<StampedFile>& depths,
                     const PairingOptions& options);

/// Adds the poses of groundtruth.txt or *.gt.freiburg; a note if there is none or it cannot be
/// read.
void add_reference(const std::filesystem::path& folder, Sequence& sequence);

/// Returns associations.txt or what other programs call it; empty if the folder has none.
std::optional<std::filesystem::path> find_association_file(const std::filesystem::path& folder);

/// Reads lines "stamp file stamp file"; paths are relative to `folder`. Which image is the depth
/// image is known from the words depth, rgb and color in the paths of the first line, else from the
/// images themselves. Adds what was repaired or left out to `notes`. Throws InputError.
std::vector<FrameFiles> read_association_list(const std::filesystem::path& list,
                                              const std::filesystem::path& folder,
                                              std::vector<std::string>& notes);

/// Returns true if all stamps are integers: numbers of frames instead of seconds.
bool has_frame_numbers(const std::vector<FrameFiles>& frames);

/// Opens the sequence that the options' list of pairs names, else the one of the folder's own list,
/// else the one of rgb.txt and depth.txt. Throws InputError.
Sequence open_image_lists(const std::filesystem::path& folder, const PairingOptions& options);

/// Returns the camera of the TUM RGB-D benchmark that a sequence was recorded with, if a comment of
/// rgb.txt names the recording: "# file: 'rgbd_dataset_freiburg1_rpy.bag'".
std::optional<SuggestedCamera> camera_of_recording(const std::filesystem::path& folder);

}  // namespace cvo_slam
