// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A folder of colour and a folder of depth images without lists, as many recorders and exporters
// write them. A number in the name of a file says when it was taken.
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/dataset/formats_internal.h"
#include "cvo_slam/io/dataset/image_lists_internal.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

/// Of names that number the frames.
ClockUnit frames_at(double rate) { return {"frames", rate, 6}; }
bool counts_frames(const ClockUnit& unit) { return unit.name == "frames"; }

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Returns the numbers of a name, each with its fraction: "3", "0012" of "cam3_frame_0012",
/// "1305031102.175" of "rgb-1305031102.175".
std::vector<std::string> numbers_of(std::string_view stem) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < stem.size();) {
    if (!is_digit(stem[i])) {
      ++i;
      continue;
    }
    bool has_point = false;
    std::size_t end = i;
    for (; end < stem.size(); ++end) {
      const bool is_point =
          stem[end] == '.' && !has_point && end + 1 < stem.size() && is_digit(stem[end + 1]);
      if (!is_digit(stem[end]) && !is_point) break;
      has_point = has_point || is_point;
    }
    numbers.emplace_back(stem.substr(i, end - i));
    i = end;
  }
  return numbers;
}

/// The images of a folder by the number in their names that says when they were taken: the last one
/// that is not the same in all.
struct NumberedImages {
  Path folder;
  std::vector<std::pair<std::string, Path>> images;
  std::size_t without_number = 0;
};

struct NamedImage {
  Path file;
  std::vector<std::string> numbers;
};

/// Returns the place of the last number that is not the same in all names; of the last one if all
/// are. Names without a number there do not count.
std::size_t place_of_number(const std::vector<NamedImage>& names, std::size_t places) {
  for (std::size_t place = places; place-- > 0;) {
    const std::string& first = names.front().numbers[place];
    if (std::any_of(names.begin(), names.end(), [&](const NamedImage& name) {
          return name.numbers.size() == places && name.numbers[place] != first;
        })) {
      return place;
    }
  }
  return places - 1;
}

NumberedImages list_images(const Path& folder) {
  NumberedImages result{folder, {}, 0};
  std::vector<NamedImage> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Path& file = entry.path();
    if (!has_image_extension(file.filename().string())) continue;
    names.push_back({file, numbers_of(file.stem().string())});
    if (names.back().numbers.empty()) {
      names.pop_back();
      ++result.without_number;
    }
  }
  if (names.empty()) return result;
  std::sort(names.begin(), names.end(),
            [](const NamedImage& a, const NamedImage& b) { return a.file < b.file; });
  const std::size_t places = names.front().numbers.size();
  const std::size_t place = place_of_number(names, places);
  for (const NamedImage& name : names) {
    if (name.numbers.size() == places) {
      result.images.emplace_back(name.numbers[place], name.file);
    } else {
      ++result.without_number;
    }
  }
  return result;
}

/// Returns what the numbers of a folder count. A number with a fraction, and one that is a time
/// from 1980 to 2096 in one of the units, is a stamp; others number the frames.
ClockUnit unit_of(const NumberedImages& images, double frame_rate) {
  const auto& numbers = images.images;
  if (std::any_of(numbers.begin(), numbers.end(),
                  [](const auto& image) { return image.first.find('.') != std::string::npos; })) {
    return {"seconds", 1, 0};
  }
  return clock_unit_of(parse_finite(numbers.front().first).value_or(0))
      .value_or(frames_at(frame_rate));
}

/// Returns the stamp that a number means; empty if it is none.
std::optional<Timestamp> stamp_of_number(std::string_view number, const ClockUnit& unit) {
  if (unit.per_second == 1) return Timestamp::parse(number);
  const auto count = parse_integer<std::int64_t>(number);
  if (!count || static_cast<double>(*count) > kLatestStamp * unit.per_second) return std::nullopt;
  if (counts_frames(unit)) return stamp_of_frame(*count, unit.per_second);
  return Timestamp(*count * static_cast<std::int64_t>(1e9 / unit.per_second), unit.decimals);
}

/// Returns the images in ascending order of their stamps; of equal ones the first.
std::vector<StampedFile> stamped(const NumberedImages& images, const ClockUnit& unit) {
  std::map<Timestamp, Path> files;
  for (const auto& [number, file] : images.images) {
    const auto stamp = stamp_of_number(number, unit);
    if (!stamp) {
      throw InputError(
          file, fmt::format("the number '{}' in the name is no time in {}", number, unit.name));
    }
    files.emplace(*stamp, file);
  }
  std::vector<StampedFile> result;
  result.reserve(files.size());
  for (const auto& [stamp, file] : files) result.push_back({stamp, file});
  return result;
}

bool has_image(const Path& folder) {
  if (!std::filesystem::is_directory(folder)) return false;
  const std::filesystem::directory_iterator files(folder);
  return std::any_of(begin(files), end(files), [](const auto& entry) {
    return has_image_extension(entry.path().filename().string());
  });
}

/// Returns the folder of the colour images; empty if there is none, or none of depth images.
std::optional<Path> color_folder(const Path& folder) {
  // A recorder that writes lists has not written both yet.
  if (std::filesystem::exists(folder / "rgb.txt") ||
      std::filesystem::exists(folder / "depth.txt")) {
    return std::nullopt;
  }
  if (!has_image(folder / "depth")) return std::nullopt;
  for (const char* name : {"rgb", "color", "colour", "images", "image"}) {
    if (has_image(folder / name)) return folder / name;
  }
  return std::nullopt;
}

void add_notes(const NumberedImages& images, std::size_t used, Sequence& sequence) {
  const std::string name = images.folder.filename().string();
  if (images.without_number > 0) {
    sequence.notes.push_back(fmt::format(
        "{}: {} images have no number in their names, or not as many as the others, and "
        "are left out",
        name, images.without_number));
  }
  if (used < images.images.size()) {
    sequence.notes.push_back(
        fmt::format("{}: {} images have the number of another and are left out", name,
                    images.images.size() - used));
  }
}

Sequence open_image_folders(const Path& folder, const PairingOptions& options) {
  const auto color = color_folder(folder);
  if (!color) throw InputError(folder, "its files changed while it was opened; try again");
  const NumberedImages color_images = list_images(*color);
  const NumberedImages depth_images = list_images(folder / "depth");
  if (color_images.images.empty() || depth_images.images.empty()) {
    throw InputError(folder,
                     "the images have no number in their names, so that it is not known "
                     "when they were taken; list them in rgb.txt and depth.txt");
  }
  const ClockUnit unit = unit_of(color_images, options.frame_rate);
  const ClockUnit depth_unit = unit_of(depth_images, options.frame_rate);
  if (unit.name != depth_unit.name) {
    throw InputError(folder,
                     fmt::format("the names of the colour images count {} and those of the depth "
                                 "images {}; pair them in associations.txt",
                                 unit.name, depth_unit.name));
  }
  const auto colors = stamped(color_images, unit);
  const auto depths = stamped(depth_images, unit);
  PairingOptions pairing = options;
  if (counts_frames(unit)) {  // an image of another number is of another time
    constexpr double kShare = 0.45;
    pairing.max_stamp_difference =
        std::min(pairing.max_stamp_difference, kShare / options.frame_rate);
  }
  Sequence sequence = pair_images(colors, depths, pairing);
  if (sequence.frames.empty()) {
    throw InputError(folder, fmt::format("no colour image has a depth image within {} s; give "
                                         "--max-diff or --depth-offset",
                                         options.max_stamp_difference));
  }
  add_notes(color_images, colors.size(), sequence);
  add_notes(depth_images, depths.size(), sequence);
  sequence.has_counted_stamps = counts_frames(unit);
  sequence.notes.push_back(
      sequence.has_counted_stamps
          ? fmt::format("stamps are the numbers in the names of the images at {} Hz; "
                        "--frame-rate sets it",
                        unit.per_second)
          : fmt::format("stamps are the numbers in the names of the images, in {}", unit.name));
  add_reference(folder, sequence);
  return sequence;
}

}  // namespace

constinit const DatasetFormat kImageFoldersFormat = {
    .name = "image folders",
    .layout = "rgb or color, and depth, files named by number or stamp",
    .recognise = [](const Path& folder) { return color_folder(folder).has_value(); },
    .named_camera = nullptr,
    .open = open_image_folders,
};

}  // namespace cvo_slam
