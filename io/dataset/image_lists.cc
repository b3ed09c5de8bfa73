// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <set>
#include <sstream>
#include <string_view>
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

/// An entry of a list: an image and its stamp.
struct ListedImage {
  Timestamp stamp;
  Path file;  // as it stands in the list
};

/// Reads stamps and names of images from the words of a line, as many as there are: a name goes on
/// until a word with the extension of an image, for names with blanks; an image without a stamp of
/// its own has that of the one before. `used` counts the words.
std::vector<ListedImage> parse_images(const TextLine& line, std::size_t& used) {
  std::vector<ListedImage> images;
  const std::vector<std::string>& words = line.words;
  for (std::size_t i = 0; i < words.size();) {
    const auto stamp = Timestamp::parse(words[i]);
    if (!stamp && images.empty()) break;
    std::size_t last = stamp ? i + 1 : i;
    std::string name;
    while (last < words.size()) {
      name += (name.empty() ? "" : " ") + words[last];
      if (has_image_extension(words[last])) break;
      ++last;
    }
    if (last >= words.size()) break;
    images.push_back({stamp.value_or(images.empty() ? Timestamp() : images.back().stamp), name});
    used = i = last + 1;
  }
  return images;
}

/// Returns the `count` images of a line "stamp file ...". What stands behind them is left out, with
/// a line in `notes` for the first such line.
std::vector<ListedImage> read_images(const TextLine& line, std::size_t count, const Path& list,
                                     std::vector<std::string>& notes) {
  std::size_t used = 0;
  std::vector<ListedImage> images = parse_images(line, used);
  if (images.empty() && line.words.size() == 2 * count) {  // names without an extension
    for (std::size_t i = 0; i < count; ++i) {
      images.push_back({parse_stamp(line, 2 * i, list), line.words[2 * i + 1]});
    }
    used = line.words.size();
  }
  if (images.size() != count) {
    throw InputError(
        list, line.number,
        fmt::format("expected '{}', found {} words",
                    count == 1 ? "stamp file" : "stamp file stamp file", line.words.size()));
  }
  const std::string note = fmt::format("{}: columns behind the names of the images are left out",
                                       list.filename().string());
  if (used < line.words.size() && std::find(notes.begin(), notes.end(), note) == notes.end()) {
    notes.push_back(note);
  }
  return images;
}

/// Returns the lines of a list without a heading such as "timestamp filename".
std::vector<TextLine> read_list_lines(const Path& list) {
  std::vector<TextLine> lines = read_word_lines(list);
  if (!lines.empty()) {
    const auto& words = lines.front().words;
    const bool is_heading = std::none_of(words.begin(), words.end(), [](const std::string& word) {
      return word.find_first_of("0123456789") != std::string::npos || has_image_extension(word);
    });
    if (is_heading) lines.erase(lines.begin());
  }
  if (lines.empty()) throw InputError(list, "lists no image; it needs lines 'stamp file'");
  return lines;
}

/// Returns true if a path leads out of the folder.
bool leads_outside(const Path& file, const Path& folder) {
  const Path relative = file.lexically_normal().lexically_relative(folder.lexically_normal());
  return relative.empty() || *relative.begin() == "..";
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

/// Returns whether the first image of a pair is the depth image.
bool is_depth_first(const std::vector<ListedImage>& pair, const Path& folder, const Path& list,
                    long line) {
  if (const auto first = names_depth(pair[0].file.string())) return *first;
  if (const auto second = names_depth(pair[1].file.string())) return !*second;
  const bool first = is_depth_image(folder / pair[0].file);
  if (first != is_depth_image(folder / pair[1].file)) return first;
  throw InputError(list, line,
                   "cannot tell the depth image: the names of the two files do not say it, and "
                   "not exactly one of them is a 16-bit image; name them rgb and depth");
}

/// Reads lines "stamp file" in ascending order of stamps; paths are relative to the list's folder.
std::vector<StampedFile> read_image_list(const Path& list, std::vector<std::string>& notes) {
  std::vector<StampedFile> images;
  for (const auto& line : read_list_lines(list)) {
    const ListedImage image = read_images(line, 1, list, notes).front();
    images.push_back({image.stamp, list.parent_path() / image.file});
  }
  repair_stamp_order(images, list.filename().string(), notes);
  return images;
}

std::vector<Timestamp> image_stamps(const std::vector<StampedFile>& images) {
  std::vector<Timestamp> stamps;
  std::transform(images.begin(), images.end(), std::back_inserter(stamps),
                 [](const StampedFile& image) { return image.stamp; });
  return stamps;
}

/// Returns each of `a` with its nearest of `b`, which several may share, if they differ by at most
/// `max_difference` [s].
std::vector<std::pair<std::size_t, std::size_t>> nearest_stamps(const std::vector<Timestamp>& a,
                                                                const std::vector<Timestamp>& b,
                                                                double max_difference) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto after = std::lower_bound(b.begin(), b.end(), a[i]);
    auto nearest = after == b.end() ? std::prev(after) : after;
    if (after != b.begin() && after != b.end() &&
        seconds_between(*std::prev(after), a[i]) <= seconds_between(a[i], *after)) {
      nearest = std::prev(after);
    }
    if (std::fabs(seconds_between(a[i], *nearest)) > max_difference) continue;
    pairs.emplace_back(i, static_cast<std::size_t>(nearest - b.begin()));
  }
  return pairs;
}

Timestamp shifted(const Timestamp& stamp, double seconds) {
  if (seconds == 0) return stamp;
  return Timestamp(stamp.nanoseconds() + std::llround(seconds * 1e9), Timestamp::kMaxDecimals);
}

Sequence open_listed_pairs(const Path& list, const Path& folder, double depth_offset) {
  Sequence sequence;
  sequence.frames = read_association_list(list, folder, sequence.notes);
  sequence.notes.push_back(
      fmt::format("frames are paired by {}{}", list.filename().string(),
                  depth_offset == 0 ? "" : "; the depth offset changes no pair"));
  return sequence;
}

bool has_two_lists(const Path& folder) {
  return std::filesystem::is_regular_file(folder / "rgb.txt") &&
         std::filesystem::is_regular_file(folder / "depth.txt");
}

Sequence open_two_lists(const Path& folder, const PairingOptions& options) {
  std::vector<std::string> notes;
  const auto colors = read_image_list(folder / "rgb.txt", notes);
  const auto depths = read_image_list(folder / "depth.txt", notes);
  Sequence sequence = pair_images(colors, depths, options);
  sequence.notes = std::move(notes);
  if (!sequence.frames.empty()) return sequence;
  throw InputError(folder,
                   fmt::format("no image of rgb.txt has one in depth.txt within {} s (rgb.txt "
                               "begins at {}, depth.txt at {}); give --max-diff or --depth-offset",
                               options.max_stamp_difference, colors.front().stamp.to_string(),
                               depths.front().stamp.to_string()));
}

/// Adds a note if images lie outside of the folder of the sequence: they are read all the same.
void note_images_outside(const Path& folder, Sequence& sequence) {
  std::size_t outside = 0;
  for (const FrameFiles& frame : sequence.frames) {
    outside += leads_outside(frame.color, folder) || leads_outside(frame.depth, folder) ? 1 : 0;
  }
  if (outside == 0) return;
  sequence.notes.push_back(fmt::format(
      "warning: the images of {} frames lie outside of the folder of the sequence", outside));
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

/// Returns the name of the recording, which TUM's rgb.txt has in a comment among its first lines,
/// "# file: 'name.bag'"; empty if there is none.
std::string recording_name(const Path& folder) {
  const Path list = folder / "rgb.txt";
  if (!std::filesystem::is_regular_file(list)) return {};
  std::istringstream text(read_text_file(list));
  for (std::string line; std::getline(text, line) && line.starts_with('#');) {
    const std::size_t key = line.find("file:");
    const std::size_t open = key == std::string::npos ? key : line.find('\'', key);
    const std::size_t close = open == std::string::npos ? open : line.find('\'', open + 1);
    if (close != std::string::npos) return line.substr(open + 1, close - open - 1);
  }
  return {};
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> associate_stamps(const std::vector<Timestamp>& a,
                                                                  const std::vector<Timestamp>& b,
                                                                  double max_difference) {
  auto candidates = find_candidates(a, b, std::llround(max_difference * 1e9));
  std::sort(candidates.begin(), candidates.end());
  std::vector<bool> a_taken(a.size());
  std::vector<bool> b_taken(b.size());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& [difference, i, j] : candidates) {
    if (a_taken[i] || b_taken[j]) continue;
    a_taken[i] = b_taken[j] = true;
    pairs.emplace_back(i, j);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool has_image_extension(std::string_view name) {
  constexpr std::array<std::string_view, 10> kExtensions = {
      ".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".tif", ".tiff", ".bmp", ".webp", ".exr"};
  const std::string lower = to_lower(std::string(name));
  return std::any_of(kExtensions.begin(), kExtensions.end(),
                     [&](std::string_view extension) { return lower.ends_with(extension); });
}

Sequence pair_images(const std::vector<StampedFile>& colors, const std::vector<StampedFile>& depths,
                     const PairingOptions& options) {
  Sequence sequence;
  std::vector<Timestamp> depth_stamps = image_stamps(depths);
  for (Timestamp& stamp : depth_stamps) stamp = shifted(stamp, options.depth_offset);
  const auto pair = options.depth_offset == 0 ? associate_stamps : nearest_stamps;
  std::set<Path> used;
  for (const auto& [i, j] :
       pair(image_stamps(colors), depth_stamps, options.max_stamp_difference)) {
    sequence.frames.push_back({colors[i].stamp, depths[j].stamp, colors[i].file, depths[j].file});
    used.insert(depths[j].file);
  }
  sequence.unpaired = {colors.size() - sequence.frames.size(), depths.size() - used.size()};
  return sequence;
}

void add_reference(const Path& folder, Sequence& sequence) {
  const auto file = find_reference_file(folder);
  if (!file) {
    sequence.notes.emplace_back("no ground truth (groundtruth.txt): errors cannot be measured");
    return;
  }
  try {
    sequence.reference = read_tum_in_any_order(*file, sequence.notes);
  } catch (const InputError& error) {
    sequence.notes.push_back(fmt::format(
        "warning: the ground truth cannot be read, errors cannot be measured: {}", error.what()));
  }
}

std::optional<Path> find_association_file(const Path& folder) {
  for (const char* name : {"associations.txt", "associated.txt", "associate.txt"}) {
    if (std::filesystem::is_regular_file(folder / name)) return folder / name;
  }
  return std::nullopt;
}

std::vector<FrameFiles> read_association_list(const Path& list, const Path& folder,
                                              std::vector<std::string>& notes) {
  std::vector<FrameFiles> frames;
  std::optional<bool> depth_first;
  for (const auto& line : read_list_lines(list)) {
    const auto pair = read_images(line, 2, list, notes);
    if (!depth_first) depth_first = is_depth_first(pair, folder, list, line.number);
    const ListedImage& color = pair[*depth_first ? 1 : 0];
    const ListedImage& depth = pair[*depth_first ? 0 : 1];
    frames.push_back({color.stamp, depth.stamp, folder / color.file, folder / depth.file});
  }
  repair_stamp_order(frames, list.filename().string(), notes);
  return frames;
}

bool has_frame_numbers(const std::vector<FrameFiles>& frames) {
  return std::all_of(frames.begin(), frames.end(), [](const FrameFiles& frame) {
    return frame.stamp.to_string().find('.') == std::string::npos;
  });
}

Sequence open_image_lists(const Path& folder, const PairingOptions& options) {
  auto list = options.associations ? options.associations : find_association_file(folder);
  std::string note;
  if (list && !options.associations && options.depth_offset != 0 && has_two_lists(folder)) {
    note = fmt::format(
        "frames are paired by rgb.txt and depth.txt, not by {}: the depth offset changes pairs",
        list->filename().string());
    list.reset();
  }
  Sequence sequence = list ? open_listed_pairs(*list, folder, options.depth_offset)
                           : open_two_lists(folder, options);
  if (!note.empty()) sequence.notes.push_back(note);
  note_images_outside(folder, sequence);
  if (has_frame_numbers(sequence.frames)) {
    sequence.notes.emplace_back("stamps are frame numbers: what is said per second is per frame");
  }
  add_reference(folder, sequence);
  return sequence;
}

std::optional<SuggestedCamera> camera_of_recording(const Path& folder) {
  const std::string name = recording_name(folder);
  constexpr std::string_view kPrefix = "rgbd_dataset_freiburg";
  if (!name.starts_with(kPrefix) || name.size() < kPrefix.size() + 2) return std::nullopt;
  const char laboratory = name[kPrefix.size()];
  if (laboratory < '1' || laboratory > '3' || name[kPrefix.size() + 1] != '_') return std::nullopt;
  return SuggestedCamera{fmt::format("tum_fr{}", laboratory),
                         fmt::format("rgb.txt says that the recording is '{}'", name)};
}

}  // namespace cvo_slam
