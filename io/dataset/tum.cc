// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// TUM RGB-D: Sturm et al., "A benchmark for the evaluation of RGB-D SLAM systems", IROS 2012.
#include "cvo_slam/io/dataset/formats_internal.h"
#include "cvo_slam/io/dataset/image_lists_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

bool is_tum(const Path& folder) {
  return find_association_file(folder) || (std::filesystem::is_regular_file(folder / "rgb.txt") &&
                                           std::filesystem::is_regular_file(folder / "depth.txt"));
}

Sequence open_tum(const Path& folder, const Camera& /*camera*/, double max_stamp_difference) {
  return open_image_lists(folder, max_stamp_difference);
}

}  // namespace

constinit const DatasetFormat kTumFormat = {
    .name = "TUM RGB-D",
    .layout = "rgb.txt and depth.txt, or associations.txt",
    .recognise = is_tum,
    .suggest_camera = camera_of_recording,
    .open = open_tum,
};

}  // namespace cvo_slam
