// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// TUM RGB-D: Sturm et al., "A benchmark for the evaluation of RGB-D SLAM systems", IROS 2012.
// ICL-NUIM (Handa et al., "A benchmark for RGB-D visual odometry, 3D reconstruction and SLAM", ICRA
// 2014) and many others are published in its layout.
#include "cvo_slam/io/dataset/formats_internal.h"
#include "cvo_slam/io/dataset/image_lists_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

bool is_tum(const Path& folder) {
  return find_association_file(folder) || (std::filesystem::is_regular_file(folder / "rgb.txt") &&
                                           std::filesystem::is_regular_file(folder / "depth.txt"));
}

}  // namespace

constinit const DatasetFormat kTumFormat = {
    .name = "TUM RGB-D",
    .layout = "rgb.txt and depth.txt, or associations.txt",
    .recognise = is_tum,
    .named_camera = camera_of_recording,
    .open = open_image_lists,
};

}  // namespace cvo_slam
