// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/tests/fuzz/targets.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/dataset/image_lists_internal.h"
#include "cvo_slam/io/g2o.h"
#include "cvo_slam/io/image_header_internal.h"
#include "cvo_slam/io/map_header_internal.h"
#include "cvo_slam/io/map_memory_files_internal.h"
#include "cvo_slam/io/options_file.h"
#include "cvo_slam/io/ply.h"
#include "cvo_slam/io/surface_file_internal.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/loop/compact_features_internal.h"
#include "cvo_slam/loop/vocabulary.h"
#include "cvo_slam/slam/compact_cloud_internal.h"
#include "cvo_slam/slam/slam_options.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

/// A folder of this process in memory, without any file of an earlier input that matters.
const fs::path& scratch_folder() {
  static const fs::path folder = [] {
    const fs::path root = fs::exists("/dev/shm") ? "/dev/shm" : fs::temp_directory_path();
    fs::path made = root / fmt::format("cvo_slam_fuzz_{}", getpid());
    fs::create_directories(made);
    std::atexit([] { fs::remove_all(scratch_folder()); });
    return made;
  }();
  return folder;
}

fs::path write_scratch(const std::string& name, std::string_view bytes) {
  fs::path file = scratch_folder() / name;
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<long>(bytes.size()));
  return file;
}

void parse_lists(std::string_view bytes) {
  write_scratch("depth.txt", "0.0 depth/0.png\n0.1 depth/1.png\n1.0 depth/2.png\n");
  write_scratch("rgb.txt", bytes);
  static_cast<void>(camera_of_recording(scratch_folder()));
  static_cast<void>(open_image_lists(scratch_folder(), {}));
}

void parse_associations(std::string_view bytes) {
  PairingOptions options;
  options.associations = write_scratch("pairs.txt", bytes);
  options.depth_offset = 0.01;
  static_cast<void>(open_image_lists(scratch_folder(), options));
}

void parse_trajectory(std::string_view bytes) {
  static_cast<void>(read_tum(write_scratch("trajectory.txt", bytes)));
}

void parse_camera(std::string_view bytes) {
  static_cast<void>(read_camera(write_scratch("camera.yaml", bytes)));
}

void parse_options(std::string_view bytes) {
  SlamOptions options;
  read_options(write_scratch("config.yaml", bytes), describe(options));
}

void parse_world(std::string_view bytes) {
  static_cast<void>(synthetic::read_world(write_scratch("world.yaml", bytes)));
}

void parse_g2o(std::string_view bytes) {
  static_cast<void>(read_g2o(write_scratch("graph.g2o", bytes)));
}

void parse_ply(std::string_view bytes) {
  static_cast<void>(read_ply(write_scratch("cloud.ply", bytes)));
}

void parse_vocabulary(std::string_view bytes) {
  static_cast<void>(read_vocabulary(write_scratch("vocabulary", bytes)));
}

void parse_image(std::string_view bytes) { static_cast<void>(parse_image_header(bytes)); }

constexpr std::string_view kMapBlob = "aaaabbbbccccdddd";

const fs::path& map_folder() {
  static const fs::path folder = [] {
    fs::create_directories(scratch_folder() / "map");
    write_scratch("map/camera.yaml",
                  "width: 640\nheight: 480\nfx: 525\nfy: 525\ncx: 320\ncy: 240\n"
                  "depth_scale: 1000\n");
    write_scratch("map/keyframes.bin", kMapBlob);
    return scratch_folder() / "map";
  }();
  return folder;
}

void parse_map_header(std::string_view bytes) {
  map_folder();
  write_scratch("map/map.yaml", bytes);
  MapHeader(map_folder()).check_small_files(map_folder());
}

/// The table of the keyframes, with the checksum that it has.
void parse_map_keyframes(std::string_view bytes) {
  map_folder();
  const auto entry = [](std::string_view name, std::string_view file) {
    return fmt::format("  {}: [{}, \"{:08x}\"]\n", name, file.size(), crc32_of(file));
  };
  write_scratch("map/map.yaml", "format: 3\nvocabulary: 0\ncos_theta: [1, 2]\nfiles:\n" +
                                    entry("keyframes.csv", bytes) +
                                    entry("keyframes.bin", kMapBlob) + entry("camera.yaml", "") +
                                    entry("graph.g2o", "") + entry("edges.txt", ""));
  write_scratch("map/keyframes.csv", bytes);
  static_cast<void>(read_memory(map_folder(), MapHeader(map_folder())));
}

/// The bytes of a keyframe, as they are after their checksum was found right.
void parse_map_bytes(std::string_view bytes) {
  if (bytes.empty()) return;
  const std::string_view rest = bytes.substr(1);
  if (bytes.front() == 'p') {
    static_cast<void>(CompactCloud::from_bytes(rest).points());
  } else if (bytes.front() == 's') {
    write_scratch("surface.bin", rest);
    CheckedFile file(scratch_folder() / "surface.bin", rest.size(), crc32_of(rest));
    Map map;
    read_surface(file, map);
  } else {
    static_cast<void>(CompactFeatures::from_bytes(rest).features(PinholeCamera()));
  }
}

constexpr std::array kTargets = {
    FuzzTarget{"lists", parse_lists},
    FuzzTarget{"associations", parse_associations},
    FuzzTarget{"trajectory", parse_trajectory},
    FuzzTarget{"camera", parse_camera},
    FuzzTarget{"options", parse_options},
    FuzzTarget{"world", parse_world},
    FuzzTarget{"g2o", parse_g2o},
    FuzzTarget{"ply", parse_ply},
    FuzzTarget{"vocabulary_binary", parse_vocabulary},
    FuzzTarget{"vocabulary_text", parse_vocabulary},
    FuzzTarget{"image_header", parse_image},
    FuzzTarget{"map_header", parse_map_header},
    FuzzTarget{"map_keyframes", parse_map_keyframes},
    FuzzTarget{"map_bytes", parse_map_bytes},
};

}  // namespace

std::span<const FuzzTarget> fuzz_targets() { return kTargets; }

void run_fuzz_target(std::string_view name, std::string_view bytes) {
  const auto* const target =
      std::find_if(kTargets.begin(), kTargets.end(),
                   [&](const FuzzTarget& candidate) { return candidate.name == name; });
  try {
    target->parse(bytes);
  } catch (const Error&) {  // the one right answer to most bytes
  }
}

}  // namespace cvo_slam
