// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// ICL-NUIM: Handa et al., "A benchmark for RGB-D visual odometry, 3D reconstruction and SLAM",
// ICRA 2014, as published in the layout of TUM RGB-D.
#include "cvo_slam/core/error.h"
#include "cvo_slam/io/dataset/formats_internal.h"
#include "cvo_slam/io/dataset/image_lists_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

bool is_icl_nuim(const Path& folder) {
  const auto file = find_association_file(folder);
  if (!file) return false;
  try {
    std::vector<std::string> notes;
    const AssociationList list = read_association_list(*file, notes);
    return list.depth_first && has_frame_numbers(list.frames);
  } catch (const InputError&) {  // open_tum(), which reads the same file, reports it
    return false;
  }
}

std::optional<SuggestedCamera> camera_of_icl_nuim(const Path& folder) {
  if (auto camera = camera_of_recording(folder)) return camera;
  return SuggestedCamera{"icl_nuim", "the layout is that of ICL-NUIM"};
}

Sequence open_icl_nuim(const Path& folder, const Camera& /*camera*/, double max_stamp_difference) {
  return open_image_lists(folder, max_stamp_difference);
}

}  // namespace

constinit const DatasetFormat kIclNuimFormat = {
    .name = "ICL-NUIM",
    .layout = "associations.txt with depth first and frame numbers as stamps",
    .recognise = is_icl_nuim,
    .suggest_camera = camera_of_icl_nuim,
    .open = open_icl_nuim,
};

}  // namespace cvo_slam
