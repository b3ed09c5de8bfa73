// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <regex>
#include <tuple>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/dataset/image_lists_internal.h"
#include "cvo_slam/io/image_files_internal.h"
#include "cvo_slam/io/text_internal.h"
#include "cvo_slam/io/trajectory_files.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

/// (difference [ns], index in a, index in b): the order in which pairs are taken.
using Candidate = std::tuple<std::int64_t, std::size_t, std::size_t>;

std::vector<Candidate> find_candidates(const std::vector<Timestamp>& a,
                                       const std::vector<Timestamp>& b, std::int64_t max) {
  std::vector<Candidate> candidates;
  std::size_t first = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto difference = [&](std::size_t j) { return b[j].nanoseconds() - a[i].nanoseconds(); };
    while (first < b.size() && difference(first) < -max) ++first;
    for (std::size_t j = first; j < b.size() && difference(j) <= max; ++j) {
      candidates.emplace_back(std::abs(difference(j)), i, j);
    }
  }
  return candidates;
}

void check_words(const TextLine& line, std::size_t count, const std::string& expected,
                 const Path& list) {
  if (line.words.size() == count) return;
  throw InputError(list, line.number,
                   fmt::format("expected '{}', found {} words", expected, line.words.size()));
}

/// Returns true if the words of a path say that the image is a depth image, false if they say that
/// it is a colour image, and nothing if they say neither or both.
std::optional<bool> names_depth(const std::string& path) {
  const std::string text = to_lower(path);
  const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
  const bool depth = has("depth");
  const bool color = has("rgb") || has("color") || has("colour");
  if (depth == color) return std::nullopt;
  return depth;
}

bool is_depth_first(const TextLine& line, const Path& list) {
  if (const auto first = names_depth(line.words[1])) return *first;
  if (const auto second = names_depth(line.words[3])) return !*second;
  const Path folder = list.parent_path();
  const bool first = is_depth_image(folder / line.words[1]);
  if (first != is_depth_image(folder / line.words[3])) return first;
  throw InputError(list, line.number,
                   "cannot tell the depth image: the names of the two files do not say it, and "
                   "not exactly one of them is a 16-bit image");
}

struct StampedFile {
  Timestamp stamp;
  Path file;
};

/// Reads lines "stamp file" in ascending order of stamps; paths are relative to the list's folder.
std::vector<StampedFile> read_image_list(const Path& list, std::vector<std::string>& notes) {
  std::vector<StampedFile> images;
  for (const auto& line : read_word_lines(list)) {
    check_words(line, 2, "stamp file", list);
    images.push_back({parse_stamp(line, 0, list), list.parent_path() / line.words[1]});
  }
  if (images.empty()) throw InputError(list, "lists no image");
  repair_stamp_order(images, list.filename().string(), notes);
  return images;
}

std::vector<Timestamp> stamps_of(const std::vector<StampedFile>& images) {
  std::vector<Timestamp> stamps;
  std::transform(images.begin(), images.end(), std::back_inserter(stamps),
                 [](const StampedFile& image) { return image.stamp; });
  return stamps;
}

Sequence open_listed_pairs(const Path& file) {
  Sequence sequence;
  sequence.frames = read_association_list(file, sequence.notes).frames;
  sequence.notes.push_back(fmt::format("frames are paired by {}", file.filename().string()));
  return sequence;
}

Sequence open_two_lists(const Path& folder, double max_difference) {
  Sequence sequence;
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
  return sequence;
}

/// Returns groundtruth.txt, or what ICL-NUIM has in its place, e.g. livingRoom2.gt.freiburg.
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

/// Returns the name of the recording, which TUM's rgb.txt has in a comment "# file: 'name.bag'";
/// empty if there is none.
std::string recording_name(const Path& folder) {
  const Path list = folder / "rgb.txt";
  if (!std::filesystem::exists(list)) return {};
  const std::string text = read_file(list);
  static const std::regex kComment("^# *file: *'([^'\n]*)'", std::regex::multiline);
  std::smatch match;
  return std::regex_search(text, match, kComment) ? match[1].str() : std::string();
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> associate_stamps(const std::vector<Timestamp>& a,
                                                                  const std::vector<Timestamp>& b,
                                                                  double max_difference) {
  auto candidates = find_candidates(a, b, std::llround(max_difference * 1e9));
  std::sort(candidates.begin(), candidates.end());
  std::vector<bool> a_taken(a.size()), b_taken(b.size());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& [difference, i, j] : candidates) {
    if (a_taken[i] || b_taken[j]) continue;
    a_taken[i] = b_taken[j] = true;
    pairs.emplace_back(i, j);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::optional<Path> find_association_file(const Path& folder) {
  for (const char* name : {"associations.txt", "associated.txt", "associate.txt"}) {
    if (std::filesystem::is_regular_file(folder / name)) return folder / name;
  }
  return std::nullopt;
}

AssociationList read_association_list(const Path& list, std::vector<std::string>& notes) {
  const auto lines = read_word_lines(list);
  if (lines.empty()) throw InputError(list, "lists no image");
  for (const auto& line : lines) check_words(line, 4, "stamp file stamp file", list);

  AssociationList result;
  result.depth_first = is_depth_first(lines.front(), list);
  const std::size_t color = result.depth_first ? 2 : 0;
  const std::size_t depth = 2 - color;
  const Path folder = list.parent_path();
  for (const auto& line : lines) {
    result.frames.push_back({parse_stamp(line, color, list), parse_stamp(line, depth, list),
                             folder / line.words[color + 1], folder / line.words[depth + 1]});
  }
  repair_stamp_order(result.frames, list.filename().string(), notes);
  return result;
}

bool has_frame_numbers(const std::vector<FrameFiles>& frames) {
  return std::all_of(frames.begin(), frames.end(), [](const FrameFiles& frame) {
    return frame.stamp.to_string().find('.') == std::string::npos;
  });
}

Sequence open_image_lists(const Path& folder, double max_stamp_difference) {
  const auto association_file = find_association_file(folder);
  Sequence sequence = association_file ? open_listed_pairs(*association_file)
                                       : open_two_lists(folder, max_stamp_difference);
  if (has_frame_numbers(sequence.frames)) {
    sequence.notes.emplace_back("stamps are frame numbers: what is said per second is per frame");
  }
  if (const auto file = find_reference_file(folder)) {
    sequence.reference = read_tum_in_any_order(*file, sequence.notes);
  } else {
    sequence.notes.emplace_back("no ground truth (groundtruth.txt): errors cannot be measured");
  }
  return sequence;
}

std::optional<std::string> camera_named_by(const std::string& sequence_name) {
  const std::string name = to_lower(sequence_name);
  std::smatch match;
  static const std::regex kTum("(?:^|[^a-z])(?:freiburg|fr)([123])(?:[^0-9]|$)");
  if (std::regex_search(name, match, kTum)) return "tum_fr" + match[1].str();
  static const std::regex kIclNuim(
      "(?:^|[^a-z])icl(?:[^a-z]|$)|living_?room|office_(?:room_)?(?:kt|traj)|traj[0-3]_frei");
  if (std::regex_search(name, kIclNuim)) return "icl_nuim";
  return std::nullopt;
}

std::optional<SuggestedCamera> camera_of_recording(const Path& folder) {
  for (const auto& name : {folder_name(folder), recording_name(folder)}) {
    const auto camera = camera_named_by(name);
    if (camera) return SuggestedCamera{*camera, fmt::format("the sequence is called '{}'", name)};
  }
  return std::nullopt;
}

}  // namespace cvo_slam
