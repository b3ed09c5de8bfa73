// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <optional>
#include <regex>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/dataset_camera_internal.h"
#include "cvo_slam/io/image_list_internal.h"
#include "cvo_slam/io/sequence_internal.h"
#include "cvo_slam/io/stamp_association_internal.h"
#include "cvo_slam/io/text_internal.h"
#include "cvo_slam/io/tum_trajectory.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

std::optional<Path> find_association_file(const Path& folder) {
  for (const char* name : {"associations.txt", "associated.txt", "associate.txt"}) {
    if (std::filesystem::is_regular_file(folder / name)) return folder / name;
  }
  return std::nullopt;
}

/// groundtruth.txt, or as ICL-NUIM names it, e.g. livingRoom2.gt.freiburg.
std::optional<Path> find_reference_file(const Path& folder) {
  if (std::filesystem::is_regular_file(folder / "groundtruth.txt")) {
    return folder / "groundtruth.txt";
  }
  std::vector<Path> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().ends_with(".gt.freiburg")) found.push_back(entry.path());
  }
  if (found.empty()) return std::nullopt;
  return *std::min_element(found.begin(), found.end());
}

std::vector<Timestamp> stamps_of(const std::vector<StampedFile>& images) {
  std::vector<Timestamp> stamps;
  std::transform(images.begin(), images.end(), std::back_inserter(stamps),
                 [](const StampedFile& image) { return image.stamp; });
  return stamps;
}

void pair_lists(const Path& folder, double max_difference, Sequence& sequence) {
  const auto colors = read_image_list(folder / "rgb.txt", sequence.notes);
  const auto depths = read_image_list(folder / "depth.txt", sequence.notes);
  for (const auto& [i, j] :
       associate_stamps(stamps_of(colors), stamps_of(depths), max_difference)) {
    sequence.frames.push_back({colors[i].stamp, depths[j].stamp, colors[i].file, depths[j].file});
  }
  if (sequence.frames.empty()) {
    throw InputError(folder, fmt::format("no image of rgb.txt has one in depth.txt within {} s",
                                         max_difference));
  }
  sequence.unpaired = {colors.size() - sequence.frames.size(),
                       depths.size() - sequence.frames.size()};
}

/// The name of the recording, which TUM's lists have in a comment: "# file: 'name.bag'".
std::string recording_name(const Path& folder) {
  const Path list = folder / "rgb.txt";
  if (!std::filesystem::exists(list)) return {};
  const std::string text = read_file(list);
  static const std::regex kComment("^# *file: *'([^'\n]*)'", std::regex::multiline);
  std::smatch match;
  return std::regex_search(text, match, kComment) ? match[1].str() : std::string();
}

/// Frame numbers instead of seconds, as ICL-NUIM has them.
bool has_integer_stamps(const std::vector<FrameFiles>& frames) {
  return std::all_of(frames.begin(), frames.end(), [](const FrameFiles& frame) {
    return frame.stamp.to_string().find('.') == std::string::npos;
  });
}

std::optional<std::string> builtin_camera_for(const Path& folder, bool is_icl_nuim) {
  if (const auto camera = camera_named_by(folder_name(folder))) return camera;
  if (const auto camera = camera_named_by(recording_name(folder))) return camera;
  return is_icl_nuim ? std::optional<std::string>("icl_nuim") : std::nullopt;
}

void add_reference(const Path& folder, Sequence& sequence) {
  const auto file = find_reference_file(folder);
  if (file) {
    sequence.reference = read_tum_in_any_order(*file, sequence.notes);
  } else {
    sequence.notes.emplace_back("no ground truth (groundtruth.txt): errors cannot be measured");
  }
}

}  // namespace

bool is_tum_folder(const Path& folder) {
  return find_association_file(folder) || (std::filesystem::is_regular_file(folder / "rgb.txt") &&
                                           std::filesystem::is_regular_file(folder / "depth.txt"));
}

Sequence open_tum_sequence(const Path& folder, const DatasetOptions& options) {
  Sequence sequence;
  sequence.name = folder_name(folder);
  bool is_icl_nuim = false;
  if (const auto file = find_association_file(folder)) {
    auto list = read_association_list(*file, sequence.notes);
    sequence.frames = std::move(list.frames);
    is_icl_nuim = list.depth_first && has_integer_stamps(sequence.frames);
    sequence.notes.push_back(fmt::format("frames are paired by {}", file->filename().string()));
  } else {
    pair_lists(folder, options.max_stamp_difference, sequence);
  }
  if (has_integer_stamps(sequence.frames)) {
    sequence.notes.emplace_back("stamps are frame numbers: what is said per second is per frame");
  }
  sequence.kind = is_icl_nuim ? "ICL-NUIM" : "TUM RGB-D";
  sequence.camera = choose_camera(folder, options, builtin_camera_for(folder, is_icl_nuim));
  add_reference(folder, sequence);
  return sequence;
}

}  // namespace cvo_slam
