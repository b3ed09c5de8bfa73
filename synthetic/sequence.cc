// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/sequence.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/parallel.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/options_file.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/synthetic/schedule_internal.h"
#include "cvo_slam/synthetic/sensor.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {
namespace {

namespace fs = std::filesystem;

/// The file that marks a folder as a synthetic sequence.
constexpr const char* kMarkerFile = "synthetic.yaml";

void require_writable_place(const fs::path& folder) {
  if (!fs::exists(folder) || fs::exists(folder / kMarkerFile)) return;
  if (!fs::is_directory(folder)) {
    throw OutputError(folder, "is not a folder; choose another output folder");
  }
  if (!fs::is_empty(folder)) {
    throw OutputError(folder, fmt::format("is not empty and not a synthetic sequence (no {}); "
                                          "choose another output folder",
                                          kMarkerFile));
  }
}

/// Removes the files that write_sequence() made; other files stay.
void remove_old_sequence(const fs::path& folder) {
  // The lists go first: after an interruption the rest is no sequence any more.
  for (const char* name : {"rgb.txt", "depth.txt", "groundtruth.txt", "camera.yaml"}) {
    fs::remove(folder / name);
  }
  for (const char* name : {"rgb", "depth"}) fs::remove_all(folder / name);
}

/// Creates the folder, or removes the sequence that an earlier call wrote there. Throws OutputError
/// if it contains anything else, so that no file of the user is lost.
void prepare_output_folder(const fs::path& folder) {
  try {
    require_writable_place(folder);
    remove_old_sequence(folder);
    fs::create_directories(folder / "rgb");
    fs::create_directories(folder / "depth");
  } catch (const fs::filesystem_error& error) {
    throw OutputError(
        folder, fmt::format("cannot be prepared ({}); check permissions", error.code().message()));
  }
}

std::size_t number_of_frames(const CameraPath& path, const SequenceOptions& options) {
  if (options.frames) return *options.frames;
  const double seconds = options.laps * path.duration();
  return static_cast<std::size_t>(std::lround(seconds * options.sensor.timing.frame_rate)) + 1;
}

void check_sequence(const SequenceOptions& options) {
  constexpr int kSmallest = 16;
  constexpr int kLargest = 4096;
  if (options.frames && *options.frames == 0) {
    throw OptionError("synthetic sequence: the number of frames must be at least 1");
  }
  for (const int side : {options.width, options.height}) {
    if (side < kSmallest || side > kLargest) {
      throw OptionError(fmt::format("synthetic sequence: image size {}x{} must be in [{}, {}]",
                                    options.width, options.height, kSmallest, kLargest));
    }
  }
  if (options.laps < 1 || options.laps > 1000) {
    throw OptionError(
        fmt::format("synthetic sequence: {} laps must be in [1, 1000]", options.laps));
  }
  check(options.sensor);
}

std::string image_name(const char* folder, const Timestamp& stamp, const char* extension) {
  return fmt::format("{}/{}{}", folder, stamp.to_string(), extension);
}

const char* extension(ImageFormat format) { return format == ImageFormat::kPng ? ".png" : ".jpg"; }

void write_image(const std::filesystem::path& file, const cv::Mat& image) {
  constexpr int kJpegQuality = 95;
  std::vector<unsigned char> bytes;
  // Without a compression level OpenCV tries one row filter only: files 5 % larger than at the
  // lowest level, in two thirds of the time. Those of the lowest level are 40 % larger than those
  // of the highest, in a tenth of the time.
  const bool encoded = cv::imencode(file.extension().string(), image, bytes,
                                    {cv::IMWRITE_JPEG_QUALITY, kJpegQuality,
                                     cv::IMWRITE_PNG_STRATEGY, cv::IMWRITE_PNG_STRATEGY_DEFAULT});
  if (!encoded) throw OutputError(file, "cannot be encoded; is OpenCV built with this format?");
  write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::string image_list(const char* title, const char* folder, const char* extension,
                       const std::vector<Timestamp>& stamps) {
  std::string text = fmt::format("# {}\n# stamp [s] file\n", title);
  for (const auto& stamp : stamps) {
    text += fmt::format("{} {}\n", stamp.to_string(), image_name(folder, stamp, extension));
  }
  return text;
}

const char* format_name(ImageFormat format) { return format == ImageFormat::kPng ? "png" : "jpeg"; }

/// Returns the options that differ from their defaults, in the syntax of the command line.
std::string settings_text(SensorOptions sensor) {
  SensorOptions defaults;
  const OptionSet ideal = describe(defaults);
  std::string text;
  for (const auto& option : describe(sensor).options()) {
    const std::string value = option.get();
    if (value == ideal.get(option.key)) continue;
    text += fmt::format(" --set sensor.{}={}", option.key, value);
  }
  return text;
}

std::string path_name(const SequenceOptions& options) {
  for (const auto& [name, style] : path_style_names()) {
    if (options.path == style) return name;
  }
  return "own";
}

std::string marker_text(const SequenceOptions& options, std::size_t frames) {
  const char* image = format_name(options.image);
  SensorOptions sensor = options.sensor;
  return fmt::format(
             "# Made by cvo_slam synth, which may replace this sequence when asked to write here "
             "again.\n# To make it again: cvo_slam synth {} <folder> --seed {}{} --path {} --speed "
             "{} "
             "--frames {} --size {}x{} --image {}{}\n",
             options.scene, options.seed,
             options.path_seed ? fmt::format(" --path-seed {}", *options.path_seed) : "",
             path_name(options), options.speed, frames, options.width, options.height, image,
             settings_text(sensor)) +
         fmt::format(
             "scene: {}\nseed: {}\npath_seed: {}\npath: {}\nspeed: {}\nframes: {}\nwidth: {}\n"
             "height: {}\nimage: {}\n",
             options.scene, options.seed, options.path_seed.value_or(options.seed),
             path_name(options), options.speed, frames, options.width, options.height, image) +
         options_to_yaml(OptionSet().add("sensor", describe(sensor)));
}

Camera camera_of(const SequenceOptions& options) {
  Camera camera = synthetic_camera(options.width, options.height);
  camera.readout_time = options.sensor.exposure.readout;
  return camera;
}

/// Writes the files of one sequence.
class Recorder {
 public:
  Recorder(const std::filesystem::path& folder, const SequenceOptions& options)
      : Recorder(folder, options,
                 make_world(options.scene, {.seed = options.seed,
                                            .path_seed = options.path_seed,
                                            .style = options.path,
                                            .speed = options.speed})) {}

  [[nodiscard]] std::size_t frames() const { return frames_.size(); }

  void write_frame(std::size_t index) const {
    const FrameTimes& frame = frames_[index];
    const Capture capture = sensor_.capture(index, frame.exposure());
    if (frame.has_color) {
      write_image(folder_ / image_name("rgb", frame.color, extension(options_.image)),
                  capture.color);
    }
    if (frame.has_depth) {
      write_image(folder_ / image_name("depth", frame.depth, ".png"), capture.depth);
    }
  }

  void write_marker() const {
    write_file(folder_ / kMarkerFile, marker_text(options_, frames_.size()));
  }

  void write_lists() const {
    write_camera(folder_ / "camera.yaml", camera_);
    write_tum(folder_ / "groundtruth.txt", {poses(reference_stamps(frames_)), {}});
    std::vector<Timestamp> color;
    std::vector<Timestamp> depth;
    for (const auto& frame : frames_) {
      if (frame.has_color) color.push_back(frame.color);
      if (frame.has_depth) depth.push_back(frame.depth);
    }
    write_file(folder_ / "depth.txt", image_list("depth images", "depth", ".png", depth));
    write_file(folder_ / "rgb.txt",
               image_list("colour images", "rgb", extension(options_.image), color));
  }

  [[nodiscard]] SequenceSummary summary() const {
    std::vector<Timestamp> stamps(frames_.size());
    std::transform(frames_.begin(), frames_.end(), stamps.begin(),
                   [](const FrameTimes& frame) { return frame.color; });
    return {frames_.size(), seconds_between(stamps.front(), stamps.back()),
            path_length(poses(stamps))};
  }

 private:
  Recorder(const std::filesystem::path& folder, const SequenceOptions& options, const World& world)
      : folder_(folder),
        options_(options),
        path_(world.path),
        camera_(camera_of(options)),
        frames_(schedule(number_of_frames(path_, options), options.sensor, options.seed)),
        sensor_(
            world.scene, [path = path_](double seconds) { return path.T_world_camera(seconds); },
            world_seconds(frames_.back().color), camera_, options.sensor, options.seed) {}

  [[nodiscard]] std::vector<StampedPose> poses(const std::vector<Timestamp>& stamps) const {
    std::vector<StampedPose> result;
    result.reserve(stamps.size());
    for (const auto& stamp : stamps) {
      result.push_back({stamp, path_.T_world_camera(world_seconds(stamp))});
    }
    return result;
  }

  std::filesystem::path folder_;
  SequenceOptions options_;
  CameraPath path_;
  Camera camera_;
  std::vector<FrameTimes> frames_;
  Sensor sensor_;
};

}  // namespace

Camera synthetic_camera(int width, int height) {
  constexpr double kFocalLengthPerWidth = 525.0 / 640.0;
  Camera camera;
  camera.name = "synthetic";
  camera.color.width = width;
  camera.color.height = height;
  camera.color.fx = kFocalLengthPerWidth * width;
  camera.color.fy = camera.color.fx;
  camera.color.cx = 0.5 * (width - 1);
  camera.color.cy = 0.5 * (height - 1);
  return camera;
}

SequenceSummary write_sequence(const std::filesystem::path& folder, const SequenceOptions& options,
                               int threads, const Progress& progress) {
  check_sequence(options);
  const Recorder recorder(folder, options);
  prepare_output_folder(folder);
  recorder.write_marker();

  // Frames are independent. Batches only serve to report progress in this thread.
  const Executor executor(threads);
  const std::size_t total = recorder.frames();
  if (progress) progress(0, total);
  const auto batch = 4 * static_cast<std::size_t>(executor.threads());
  for (std::size_t first = 0; first < total; first += batch) {
    const std::size_t count = std::min(batch, total - first);
    executor.for_each_chunk(count, 1, [&](std::size_t i, std::size_t, std::size_t) {
      recorder.write_frame(first + i);
    });
    if (progress) progress(first + count, total);
  }
  recorder.write_lists();
  return recorder.summary();
}

}  // namespace cvo_slam::synthetic
