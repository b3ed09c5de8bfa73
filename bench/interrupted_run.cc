// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures runs whose camera is blind for a while: the frames of two seconds are white, black or
// blurred beyond recognition. Prints a table of docs/results/place-recognition.md.
//   interrupted_run [--seconds 2] [--at 0.5] [--frames n] [--blind white,black,blurred] sequence...
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/core/association.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/slam.h"

namespace cvo_slam {
namespace {

struct InterruptionArguments {
  std::vector<std::string> sequences;
  std::vector<std::string> blind = {"white", "black", "blurred"};
  double seconds = 2;
  double at = 0.5;  // where the camera goes blind, as a share of the sequence
  std::size_t frames = 1000000000;
};

/// The frames [begin, end) in which the camera is blind.
struct Interruption {
  std::string kind;  // empty if the camera is never blind
  std::size_t begin = 0;
  std::size_t end = 0;

  [[nodiscard]] bool holds(std::size_t frame) const { return begin <= frame && frame < end; }
};

void spoil(RgbdFrame& frame, const std::string& kind) {
  if (frame.color.empty() || frame.depth.empty()) return;
  if (kind == "blurred") {
    constexpr double kWidth = 40;  // [px]; standard deviation
    cv::GaussianBlur(frame.color, frame.color, {}, kWidth);
    cv::GaussianBlur(frame.depth, frame.depth, {}, kWidth);
    return;
  }
  frame.color.setTo(kind == "white" ? cv::Scalar::all(255) : cv::Scalar::all(0));
  frame.depth.setTo(0);
}

struct Outcome {
  std::size_t lost = 0;      // frames without a final pose
  std::size_t in_blind = 0;  // blind frames without a final pose
  double resumed = -1;       // time from the last blind frame to the first pose after it [s]
  double ate = 0;            // [m]
};

Outcome track(const Dataset& data, std::size_t frames, const Interruption& interruption) {
  SlamOptions options;
  options.loops.enabled = true;
  Slam slam(data.camera(), options);
  for (std::size_t i = 0; i < frames; ++i) {
    RgbdFrame frame = data.read(i);
    if (!interruption.kind.empty() && interruption.holds(i)) spoil(frame, interruption.kind);
    slam.track(frame);
  }
  slam.finish();
  const Trajectory trajectory = slam.trajectory();
  Outcome outcome;
  outcome.lost = trajectory.lost.size();
  for (const LostFrame& lost : trajectory.lost) {
    for (std::size_t i = interruption.begin; i < interruption.end; ++i) {
      if (data.stamp(i) == lost.stamp) ++outcome.in_blind;
    }
  }
  for (const StampedPose& pose : trajectory.poses) {
    const double seconds = seconds_between(data.stamp(interruption.end), pose.stamp);
    if (seconds < 0) continue;
    outcome.resumed = seconds;
    break;
  }
  outcome.ate = absolute_trajectory_error(associate(data.reference(), trajectory.poses))
                    .statistics.translation.rmse;
  return outcome;
}

void run(const InterruptionArguments& arguments) {
  fmt::print(
      "| sequence | blind | lost frames | of them blind | first pose after | ATE | undisturbed | "
      "ratio |\n|---|---|---|---|---|---|---|---|\n");
  for (const std::string& path : arguments.sequences) {
    const auto data = open_dataset(path);
    const std::size_t frames = std::min(arguments.frames, data->size());
    Interruption interruption;
    interruption.begin = static_cast<std::size_t>(arguments.at * static_cast<double>(frames));
    interruption.end = interruption.begin;
    while (interruption.end + 1 < frames &&
           seconds_between(data->stamp(interruption.begin), data->stamp(interruption.end)) <
               arguments.seconds) {
      ++interruption.end;
    }
    const Outcome undisturbed = track(*data, frames, interruption);
    for (const std::string& kind : arguments.blind) {
      interruption.kind = kind;
      const Outcome outcome = track(*data, frames, interruption);
      const std::string resumed =
          outcome.resumed < 0 ? "never" : fmt::format("{:.2f} s", outcome.resumed);
      fmt::print("| {} | {} | {} | {} | {} | {:.1f} mm | {:.1f} mm | {:.2f} |\n", data->name(),
                 kind, outcome.lost, outcome.in_blind, resumed, 1000 * outcome.ate,
                 1000 * undisturbed.ate, outcome.ate / undisturbed.ate);
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace cvo_slam

// NOLINTNEXTLINE(bugprone-exception-escape): options that are defined wrongly throw, no others
int main(int argc, char** argv) {
  cvo_slam::InterruptionArguments arguments;
  CLI::App app("Measures runs whose camera is blind for a while");
  app.add_option("sequences", arguments.sequences)->required();
  app.add_option("--seconds", arguments.seconds, "Duration of the blindness [s]")
      ->capture_default_str();
  app.add_option("--at", arguments.at, "Where the blindness begins, as a share of the sequence")
      ->capture_default_str();
  app.add_option("--frames", arguments.frames, "Number of frames, from the first of each sequence");
  app.add_option("--blind", arguments.blind, "Kinds of blindness: white, black, blurred")
      ->delimiter(',');
  CLI11_PARSE(app, argc, argv);
  return cvo_slam::report_errors([&] { cvo_slam::run(arguments); });
}
