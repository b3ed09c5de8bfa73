// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/dataset/camera_choice_internal.h"
#include "cvo_slam/io/image_files_internal.h"
#include "cvo_slam/io/reprojection_internal.h"
#include "cvo_slam/io/text_internal.h"
#include "cvo_slam/io/yaml_value.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

/// Returns the folders in which a recording keeps what belongs to it: its own, those of its images,
/// and the one above.
std::vector<Path> folders_of(const Path& folder, const Sequence& sequence) {
  const Path own = std::filesystem::canonical(folder);
  std::vector<Path> folders = {own};
  if (!sequence.frames.empty()) {
    for (const Path& image : {sequence.frames.front().color, sequence.frames.front().depth}) {
      std::error_code problem;
      const Path place = std::filesystem::weakly_canonical(image.parent_path(), problem);
      if (!problem && std::find(folders.begin(), folders.end(), place) == folders.end()) {
        folders.push_back(place);
      }
    }
  }
  if (own.has_parent_path() && own.parent_path() != own) folders.push_back(own.parent_path());
  return folders;
}

std::set<Path> files_in(const Path& folder) {
  std::set<Path> files;
  std::error_code problem;
  for (auto entry = std::filesystem::directory_iterator(folder, problem);
       !problem && entry != std::filesystem::directory_iterator(); entry.increment(problem)) {
    std::error_code unreadable;
    if (entry->is_regular_file(unreadable)) files.insert(entry->path());
  }
  return files;
}

bool is_yaml(const Path& file) {
  const std::string extension = to_lower(file.extension().string());
  return extension == ".yaml" || extension == ".yml";
}

/// Returns true if a YAML file has the keys of one of the formats that read_camera() reads. What
/// other programs keep in YAML is not a camera; a file that is no YAML is neither.
bool is_camera_file(const Path& file) {
  try {
    const YamlValue root = YamlValue::read(file);
    return root.find("fx") != nullptr || root.find("Camera.fx") != nullptr ||
           root.find("Camera1.fx") != nullptr;
  } catch (const InputError&) {
    return false;
  }
}

/// Returns true if the name of a file says that it describes a camera, in whatever format.
bool names_camera(const Path& file) {
  constexpr std::uintmax_t kLargest = 1 << 20;
  std::error_code problem;
  if (std::filesystem::file_size(file, problem) > kLargest || problem) return false;
  const std::string name = to_lower(file.filename().string());
  const std::string extension = to_lower(file.extension().string());
  constexpr std::array<std::string_view, 11> kTexts = {
      ".txt", ".json", ".yaml", ".yml", ".xml", ".ini", ".cfg", ".csv", ".npy", ".calib", ""};
  if (std::find(kTexts.begin(), kTexts.end(), extension) == kTexts.end()) return false;
  // 7-Scenes-like recordings of other groups have "info.txt", "_info.txt".
  return name.find("intrinsic") != std::string::npos || name.starts_with("calib") ||
         name.starts_with("camera") || name.starts_with("cam0") || name == "info.txt" ||
         name == "_info.txt" || name == "k.txt";
}

/// Returns the camera file of a recording in a format that is read; camera.yaml before others.
/// Throws InputError if there are several others in one folder.
std::optional<Path> find_camera_file(const std::vector<Path>& folders) {
  for (const Path& folder : folders) {
    for (const char* name : {"camera.yaml", "camera.yml"}) {
      if (std::filesystem::is_regular_file(folder / name)) return folder / name;
    }
    std::vector<Path> found;
    for (const Path& file : files_in(folder)) {
      if (is_yaml(file) && is_camera_file(file)) found.push_back(file);
    }
    if (found.size() == 1) return found.front();
    if (found.size() > 1 && folder == folders.front()) {
      throw InputError(folder,
                       fmt::format("has several camera files ({} and {}): which one is the "
                                   "camera of this sequence? Give it with --camera",
                                   found[0].filename().string(), found[1].filename().string()));
    }
  }
  return std::nullopt;
}

/// Returns the files that describe the camera in a format that is not read.
std::vector<Path> find_foreign_camera_files(const std::vector<Path>& folders) {
  std::vector<Path> found;
  for (const Path& folder : folders) {
    for (const Path& file : files_in(folder)) {
      if (names_camera(file)) found.push_back(file);
    }
  }
  return found;
}

/// Returns true if a file is a 3x3 matrix of intrinsics that are those of the colour or the depth
/// camera, to a hundredth.
bool states_intrinsics_of(const Path& file, const Camera& camera) {
  const std::vector<std::string> words = split_words(read_file(file));
  if (words.size() != 9) return false;
  std::vector<double> k(words.size());
  std::transform(words.begin(), words.end(), k.begin(),
                 [](const std::string& word) { return parse_finite(word).value_or(std::nan("")); });
  const auto matches = [&](const PinholeCamera& pinhole) {
    const auto near = [](double a, double b) { return std::fabs(a - b) <= 0.01 * std::fabs(b); };
    return near(k[0], pinhole.fx) && near(k[4], pinhole.fy) && near(k[2], pinhole.cx) &&
           near(k[5], pinhole.cy);
  };
  return matches(camera.color) || (camera.depth && matches(camera.depth->pinhole));
}

std::string place_of(const Path& file, const std::vector<Path>& folders) {
  const Path place = file.parent_path();
  if (place == folders.front()) return "in the folder of the sequence";
  if (place == folders.front().parent_path()) return "in the folder above the sequence";
  return fmt::format("in the folder {}", place.filename().string());
}

[[noreturn]] void fail_without_camera(const Path& folder, const std::vector<Path>& foreign,
                                      const std::vector<Path>& folders) {
  const std::string found =
      foreign.empty()
          ? ""
          : fmt::format(" ({} {} is in a format that is not read)",
                        foreign.front().filename().string(), place_of(foreign.front(), folders));
  throw InputError(folder,
                   fmt::format("the camera of this sequence is not known{}; give --camera (a YAML "
                               "file, or one of {}) or put a camera.yaml into the folder",
                               found, fmt::join(builtin_camera_names(), ", ")));
}

/// The images of the pairs that cameras are compared on, decoded once.
struct DecodedPair {
  std::size_t a = 0;
  std::size_t b = 0;
  cv::Mat grey_a, depth_a, grey_b, depth_b;
};

std::vector<Timestamp> stamps_of(const Sequence& sequence) {
  std::vector<Timestamp> stamps;
  for (const FrameFiles& frame : sequence.frames) stamps.push_back(frame.stamp);
  return stamps;
}

std::vector<DecodedPair> decode_pairs(const Sequence& sequence, const FrameReader& reader) {
  std::vector<DecodedPair> pairs;
  for (const auto& [a, b] : choose_pairs(posed_frames(stamps_of(sequence), sequence.reference))) {
    try {
      const FrameFiles& files_a = sequence.frames[a.index];
      const FrameFiles& files_b = sequence.frames[b.index];
      pairs.push_back({a.index, b.index, to_grey(reader.read_color(files_a.color)),
                       reader.read_raw_depth(files_a.depth),
                       to_grey(reader.read_color(files_b.color)),
                       reader.read_raw_depth(files_b.depth)});
    } catch (const InputError&) {  // an image that is damaged says nothing about the camera
    }
  }
  return pairs;
}

/// Returns how badly the pairs agree with a camera: the product of both errors. Empty if they
/// cannot tell.
std::optional<double> disagreement(const Sequence& sequence, const std::vector<DecodedPair>& pairs,
                                   const Camera& camera) {
  const FrameReader reader(camera, sequence.invalid_depth);
  const auto poses = reference_of(sequence, camera);
  std::vector<Reprojection> agreements;
  for (const DecodedPair& pair : pairs) {
    const auto pose = [&](std::size_t frame) {
      return interpolate_at(poses, sequence.frames[frame].stamp, kMaxPoseGap);
    };
    const auto T_world_a = pose(pair.a);
    const auto T_world_b = pose(pair.b);
    if (!T_world_a || !T_world_b) continue;
    const auto agreement = reproject({pair.grey_a, reader.register_depth(pair.depth_a)},
                                     {pair.grey_b, reader.register_depth(pair.depth_b)},
                                     T_world_a->inverse() * *T_world_b, camera);
    if (agreement) agreements.push_back(*agreement);
  }
  const auto median = median_of(agreements);
  if (!median) return std::nullopt;
  return median->color_error * median->depth_error;
}

/// Returns the camera with other focal lengths.
Camera zoomed(Camera camera, double factor) {
  for (double* focal : {&camera.color.fx, &camera.color.fy}) *focal *= factor;
  if (camera.depth) {
    for (double* focal : {&camera.depth->pinhole.fx, &camera.depth->pinhole.fy}) *focal *= factor;
  }
  return camera;
}

/// Returns the cameras that a recording in the style of a published one would have instead.
std::vector<Camera> variants_of(const Camera& camera) {
  std::vector<Camera> variants = {zoomed(camera, 0.92), zoomed(camera, 1.08)};
  if (camera.depth) {
    Camera registered = camera;
    registered.depth.reset();
    variants.push_back(registered);
  }
  return variants;
}

/// Returns the built-in cameras that have the size of the images.
std::vector<std::pair<std::string, Camera>> cameras_of_size(const Sequence& sequence) {
  std::vector<std::pair<std::string, Camera>> cameras;
  try {
    const cv::Size color = read_image_size(sequence.frames.front().color);
    const cv::Size depth = read_image_size(sequence.frames.front().depth);
    for (const std::string& name : builtin_camera_names()) {
      const Camera camera = builtin_camera(name);
      const PinholeCamera& depths = camera.depth ? camera.depth->pinhole : camera.color;
      if (color == cv::Size(camera.color.width, camera.color.height) &&
          depth == cv::Size(depths.width, depths.height)) {
        cameras.emplace_back(name, camera);
      }
    }
  } catch (const InputError&) {  // said when the frame is read
  }
  return cameras;
}

}  // namespace

std::vector<StampedPose> reference_of(const Sequence& sequence, const Camera& camera) {
  std::vector<StampedPose> poses = sequence.reference;
  if (!sequence.reference_is_of_depth || !camera.depth) return poses;
  const SE3 T_depth_color = camera.depth->T_color_depth.inverse();
  for (StampedPose& pose : poses) pose.T_world_camera = pose.T_world_camera * T_depth_color;
  return poses;
}

std::optional<std::string> camera_singled_out_by_images(const Sequence& sequence) {
  if (sequence.reference.size() < 2) return std::nullopt;
  const auto cameras = cameras_of_size(sequence);
  if (cameras.empty()) return std::nullopt;
  const FrameReader reader(cameras.front().second, sequence.invalid_depth);
  const auto pairs = decode_pairs(sequence, reader);
  std::vector<std::pair<double, std::size_t>> ranking;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const auto value = disagreement(sequence, pairs, cameras[i].second);
    if (!value) return std::nullopt;
    ranking.emplace_back(*value, i);
  }
  std::sort(ranking.begin(), ranking.end());
  constexpr double kSeveral = 4;  // both errors twice as large
  if (ranking.size() > 1 && ranking[1].first < kSeveral * ranking[0].first) return std::nullopt;
  const auto& [name, camera] = cameras[ranking[0].second];
  for (const Camera& variant : variants_of(camera)) {
    const auto value = disagreement(sequence, pairs, variant);
    // The steps of a hand-held camera of 5 frames hardly change with the focal length.
    constexpr double kNotBetter = 0.95;
    if (value && *value < kNotBetter * ranking[0].first) return std::nullopt;
  }
  return name;
}

ChosenCamera choose_camera(const Path& folder, const std::optional<Camera>& given,
                           const DatasetFormat& format, const Sequence& sequence) {
  if (given) {
    given->check();
    return {*given, "given by the caller"};
  }
  const std::vector<Path> folders = folders_of(folder, sequence);
  if (const auto file = find_camera_file(folders)) {
    return {read_camera(*file),
            fmt::format("{} {}", file->filename().string(), place_of(*file, folders))};
  }
  std::optional<SuggestedCamera> evidence;
  if (format.named_camera != nullptr) evidence = format.named_camera(folder);
  if (!evidence) {
    if (const auto name = camera_singled_out_by_images(sequence)) {
      evidence = {*name,
                  "frames re-project several times better with it than with another "
                  "built-in camera"};
    }
  }
  const std::vector<Path> foreign = find_foreign_camera_files(folders);
  if (!evidence) fail_without_camera(folder, foreign, folders);
  const Camera camera = builtin_camera(evidence->name);
  for (const Path& file : foreign) {
    if (states_intrinsics_of(file, camera)) continue;
    throw InputError(
        folder, fmt::format("{} {} is in a format that is not read, and so it is not known whether "
                            "the camera is {}; give --camera (a YAML file, or one of {})",
                            file.filename().string(), place_of(file, folders), evidence->name,
                            fmt::join(builtin_camera_names(), ", ")));
  }
  return {camera, evidence->reason};
}

}  // namespace cvo_slam
