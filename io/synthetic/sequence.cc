// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/synthetic/sequence.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/parallel.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/synthetic/output_folder_internal.h"
#include "cvo_slam/io/synthetic/renderer.h"
#include "cvo_slam/io/synthetic/world.h"
#include "cvo_slam/io/tum_trajectory.h"

namespace cvo_slam::synthetic {
namespace {

constexpr std::int64_t kFrameRate = 30;  // [Hz]
// Not zero, so that all stamps have as many digits and file names sort in the order of time.
constexpr std::int64_t kFirstSecond = 1000;

/// Whole microseconds, which is what the file names carry: the pose is that of this very instant.
std::int64_t microseconds(std::size_t frame) {
  constexpr std::int64_t kMicroseconds = 1000000;
  return (static_cast<std::int64_t>(frame) * kMicroseconds + kFrameRate / 2) / kFrameRate;
}

StampedPose pose_of(const CameraPath& path, std::size_t frame) {
  const std::int64_t elapsed = microseconds(frame);
  const Timestamp stamp((kFirstSecond * 1000000 + elapsed) * 1000);
  return {stamp, path.T_world_camera(static_cast<double>(elapsed) * 1e-6)};
}

std::size_t frames_of_a_round(const CameraPath& path) {
  return static_cast<std::size_t>(std::lround(path.duration() * kFrameRate)) + 1;
}

void check(const SequenceOptions& options) {
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
}

std::string image_name(const char* folder, const Timestamp& stamp, const char* extension) {
  return fmt::format("{}/{}{}", folder, stamp.to_string(), extension);
}

const char* extension(ImageFormat format) { return format == ImageFormat::kPng ? ".png" : ".jpg"; }

void write_image(const std::filesystem::path& file, const cv::Mat& image) {
  constexpr int kJpegQuality = 95;
  // The lowest level: 40 % larger files than the highest in a tenth of the time.
  constexpr int kPngLevel = 1;
  std::vector<unsigned char> bytes;
  const bool encoded = cv::imencode(
      file.extension().string(), image, bytes,
      {cv::IMWRITE_JPEG_QUALITY, kJpegQuality, cv::IMWRITE_PNG_COMPRESSION, kPngLevel});
  if (!encoded) throw OutputError(file, "cannot be encoded; is OpenCV built with this format?");
  write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// Metres to 16-bit units; what is beyond their range is left without depth.
cv::Mat quantized_depth(const cv::Mat& metres, double scale) {
  cv::Mat units(metres.size(), CV_16UC1);
  std::transform(metres.begin<double>(), metres.end<double>(), units.begin<std::uint16_t>(),
                 [scale](double depth) {
                   const double rounded = std::round(depth * scale);
                   return rounded <= 65535 ? static_cast<std::uint16_t>(rounded) : std::uint16_t{0};
                 });
  return units;
}

std::string image_list(const char* title, const char* folder, const char* extension,
                       const std::vector<StampedPose>& poses) {
  std::string text = fmt::format("# {}\n# stamp [s] file\n", title);
  for (const auto& pose : poses) {
    text +=
        fmt::format("{} {}\n", pose.stamp.to_string(), image_name(folder, pose.stamp, extension));
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
  return fmt::format(
      "# Made by cvo_slam synth, which may replace this sequence when asked to write here again.\n"
      "scene: {}\nseed: {}\npath: {}\nspeed: {}\nframes: {}\nwidth: {}\nheight: {}\nnoise: none\n",
      options.scene, options.seed, path_name(options), options.speed, frames, options.width,
      options.height);
}

/// One sequence in the making.
class Recorder {
 public:
  Recorder(const std::filesystem::path& folder, const SequenceOptions& options)
      : folder_(folder),
        options_(options),
        world_(make_world(options.scene, {options.seed, options.path, options.speed})),
        camera_(synthetic_camera(options.width, options.height)) {
    const std::size_t frames = options.frames.value_or(frames_of_a_round(world_.path));
    for (std::size_t i = 0; i < frames; ++i) poses_.push_back(pose_of(world_.path, i));
  }

  [[nodiscard]] const std::vector<StampedPose>& poses() const { return poses_; }

  void write_frame(std::size_t index) const {
    const StampedPose& pose = poses_[index];
    const Rendering rendering = render(world_.scene, camera_.color, pose.T_world_camera);
    cv::Mat color;
    rendering.color.convertTo(color, CV_8UC3);
    write_image(folder_ / image_name("rgb", pose.stamp, extension(options_.image)), color);
    write_image(folder_ / image_name("depth", pose.stamp, ".png"),
                quantized_depth(rendering.depth, camera_.depth_scale));
  }

  void write_marker() const {
    write_file(folder_ / kMarkerFile, marker_text(options_, poses_.size()));
  }

  void write_lists() const {
    write_camera(folder_ / "camera.yaml", camera_);
    write_tum(folder_ / "groundtruth.txt", {poses_, {}});
    write_file(folder_ / "depth.txt", image_list("depth images", "depth", ".png", poses_));
    write_file(folder_ / "rgb.txt",
               image_list("colour images", "rgb", extension(options_.image), poses_));
  }

 private:
  std::filesystem::path folder_;
  SequenceOptions options_;
  World world_;
  Camera camera_;
  std::vector<StampedPose> poses_;
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
  check(options);
  const Recorder recorder(folder, options);
  prepare_output_folder(folder);
  recorder.write_marker();

  // Frames are independent; batches only serve to report progress from this thread.
  const Executor executor(threads);
  const std::size_t total = recorder.poses().size();
  const auto batch = static_cast<std::size_t>(4 * executor.threads());
  for (std::size_t first = 0; first < total; first += batch) {
    const std::size_t count = std::min(batch, total - first);
    executor.for_each_chunk(count, 1, [&](std::size_t i, std::size_t, std::size_t) {
      recorder.write_frame(first + i);
    });
    if (progress) progress(first + count, total);
  }
  recorder.write_lists();
  return {total, seconds_between(recorder.poses().front().stamp, recorder.poses().back().stamp),
          path_length(recorder.poses())};
}

}  // namespace cvo_slam::synthetic
