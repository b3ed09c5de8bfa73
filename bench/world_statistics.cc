// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures what a feature detector and the tracker find in real images and in the synthetic worlds.
// Prints the table of docs/results/synthetic-images.md and draws the pictures of
// docs/images/worlds.
//   world_statistics [--real <sequence>]... [--frames 12] [--pictures <folder>] [--only <world>]
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <opencv2/features2d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam {
namespace {

/// Upper ends of the bins of gradient magnitude [grey levels a pixel].
constexpr std::array<double, 7> kBins = {1, 2, 4, 8, 16, 32, 1e9};

struct WorldStatistics {
  std::array<double, kBins.size()> histogram{};  // shares of all pixels
  double median_gradient = 0;
  double brightness = 0;
  double keypoints = 0;  // number of ORB key points, at most 1000
  double response = 0;   // median of their Harris scores, times 1e6
  double points = 0;     // number of selected points, at most 6000
  double frames = 0;

  void operator/=(double count) {
    for (double& share : histogram) share /= count;
    for (double* value : {&median_gradient, &brightness, &keypoints, &response, &points}) {
      *value /= count;
    }
  }
};

template <typename Value>
double median(std::vector<Value> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void add_gradients(const cv::Mat& grey, WorldStatistics& sum) {
  cv::Mat dx;
  cv::Mat dy;
  cv::spatialGradient(grey, dx, dy, 3);
  std::vector<float> magnitudes;
  std::array<double, kBins.size()> counts{};
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) {
      const float magnitude = std::hypot(static_cast<float>(dx.at<short>(y, x)),
                                         static_cast<float>(dy.at<short>(y, x))) /
                              8;
      magnitudes.push_back(magnitude);
      const auto bin = std::upper_bound(kBins.begin(), kBins.end(), magnitude) - kBins.begin();
      counts[static_cast<std::size_t>(bin)] += 1;
    }
  }
  const auto total = static_cast<double>(magnitudes.size());
  for (std::size_t i = 0; i < counts.size(); ++i) sum.histogram[i] += counts[i] / total;
  sum.median_gradient += median(std::move(magnitudes));
}

void add_frame(const RgbdFrame& frame, const Camera& camera, WorldStatistics& sum) {
  cv::Mat grey;
  cv::cvtColor(frame.color, grey, cv::COLOR_BGR2GRAY);
  add_gradients(grey, sum);
  sum.brightness += cv::mean(grey)[0];
  std::vector<cv::KeyPoint> keypoints;
  cv::ORB::create(1000)->detect(grey, keypoints);
  sum.keypoints += static_cast<double>(keypoints.size());
  std::vector<float> responses;
  responses.reserve(keypoints.size());
  for (const auto& keypoint : keypoints) responses.push_back(1e6F * keypoint.response);
  sum.response += median(std::move(responses));
  sum.points += static_cast<double>(select_points(frame, camera, 6000).size());
  sum.frames += 1;
}

RgbdFrame frame_of(const synthetic::World& world, const Camera& camera, double seconds) {
  const auto rendering = render(synthetic::scene_at(world.scene, seconds), camera.color,
                                world.path.T_world_camera(seconds));
  RgbdFrame frame;
  rendering.color.convertTo(frame.color, CV_8UC3);
  rendering.depth.convertTo(frame.depth, CV_16UC1, camera.depth_scale);
  return frame;
}

WorldStatistics of_world(const synthetic::World& world, int frames) {
  const Camera camera = synthetic::synthetic_camera(640, 480);
  WorldStatistics sum;
  for (int i = 0; i < frames; ++i) {
    add_frame(frame_of(world, camera, world.path.duration() * (i + 0.5) / frames), camera, sum);
  }
  sum /= frames;
  return sum;
}

WorldStatistics of_sequence(const std::string& folder, int frames) {
  const auto data = open_dataset(folder);
  WorldStatistics sum;
  for (int i = 0; i < frames; ++i) {
    const auto index =
        static_cast<std::size_t>((i + 0.5) / frames * static_cast<double>(data->size()));
    const RgbdFrame frame = data->read(index);
    if (frame.problem.empty()) add_frame(frame, data->camera(), sum);
  }
  sum /= sum.frames;
  return sum;
}

void print_row(const std::string& name, const WorldStatistics& s) {
  std::string shares;
  for (const double share : s.histogram) shares += fmt::format(" {:.1f} |", 100 * share);
  fmt::print("| {} |{} {:.1f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} |\n", name, shares,
             s.median_gradient, s.brightness, s.keypoints, s.response, s.points);
  std::fflush(stdout);
}

/// Writes three views side by side.
void write_picture(const synthetic::World& world, const std::filesystem::path& file) {
  const Camera camera = synthetic::synthetic_camera(400, 300);
  std::vector<cv::Mat> views;
  for (const double share : {0.25, 0.46, 0.82}) {
    views.push_back(frame_of(world, camera, share * world.path.duration()).color);
  }
  cv::Mat picture;
  cv::hconcat(views, picture);
  constexpr std::size_t kLargest = 60000;  // [bytes]; small enough for the repository
  std::vector<unsigned char> bytes;
  for (int quality = 90; quality > 20; quality -= 5) {
    cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
    if (bytes.size() <= kLargest) break;
  }
  write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

struct StatisticsArguments {
  std::vector<std::string> real;
  std::vector<std::string> worlds = synthetic::world_names();
  std::string pictures;
  int frames = 12;
};

void run(const StatisticsArguments& arguments) {
  fmt::print(
      "| sequence | < 1 | 1 - 2 | 2 - 4 | 4 - 8 | 8 - 16 | 16 - 32 | > 32 | median | brightness | "
      "keypoints | response | points |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& folder : arguments.real) {
    print_row(std::filesystem::path(folder).filename().string(),
              of_sequence(folder, arguments.frames));
  }
  if (!arguments.pictures.empty()) make_folder(arguments.pictures);
  for (const auto& name : arguments.worlds) {
    const auto world = synthetic::make_world(name);
    if (!arguments.pictures.empty()) {
      const auto stem = std::filesystem::path(name).stem().string();
      write_picture(world, std::filesystem::path(arguments.pictures) / (stem + ".jpg"));
    }
    print_row(name, of_world(world, arguments.frames));
  }
}

}  // namespace
}  // namespace cvo_slam

// NOLINTNEXTLINE(bugprone-exception-escape): options that are defined wrongly throw, no others
int main(int argc, char** argv) {
  cvo_slam::StatisticsArguments arguments;
  CLI::App app("Measures and draws the synthetic worlds");
  app.add_option("--real", arguments.real, "Recorded sequences to compare with");
  app.add_option("--only", arguments.worlds, "Names of worlds, or world files");
  app.add_option("--frames", arguments.frames, "Number of frames of each sequence, evenly spread")
      ->check(CLI::Range(1, 10000));
  app.add_option("--pictures", arguments.pictures, "Folder for a picture of each world");
  CLI11_PARSE(app, argc, argv);
  return cvo_slam::report_errors([&] { cvo_slam::run(arguments); });
}
