// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plays a recording forwards and backwards, again and again, as one long sequence, and prints what
// each pass costs: keyframes, memory and CPU time a frame; after the first and the last pass also
// the error of the trajectory so far, whose computation takes memory of its own. Played backwards,
// a recording needs images of one time (synchronised streams, no rolling shutter). A row of
// docs/results/soak.md for each pass.
//   soak [--passes N] [--rows-every N] [--frames N] [--max-memory MB] [--keep-all] [--cyclic]
//        sequence
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/core/association.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/slam.h"

namespace cvo_slam {
namespace {

constexpr double kBytesOfMegabyte = 1024.0 * 1024;

/// Memory that the process has now [MB].
double resident_megabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0;
  double resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / kBytesOfMegabyte;
}

double process_cpu_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

struct Arguments {
  std::string sequence;
  int passes = 10;
  int rows_every = 1;
  std::size_t frames = 0;
  bool cyclic = false;
  SlamOptions options;
};

/// A recording as one long sequence: pass 0 forwards, pass 1 backwards or, for one that ends where
/// it began, forwards again.
class LongSequence {
 public:
  explicit LongSequence(const Arguments& arguments)
      : data_(open_dataset(arguments.sequence)), cyclic_(arguments.cyclic) {
    length_ = arguments.frames > 0 ? std::min(arguments.frames, data_->size()) : data_->size();
    if (length_ < 2) throw DataError(arguments.sequence + ": fewer than two frames");
    const RgbdFrame first = data_->read(0);
    const RgbdFrame last = data_->read(length_ - 1);
    period_ = seconds_between(first.stamp, last.stamp) / static_cast<double>(length_ - 1);
  }

  [[nodiscard]] const Camera& camera() const { return data_->camera(); }
  [[nodiscard]] std::size_t length() const { return length_; }

  /// The frame at a place of the long sequence. Its true pose, if there is one, is kept.
  RgbdFrame read(std::size_t index) {
    const std::size_t pass = index / length_;
    const std::size_t place = index % length_;
    RgbdFrame frame = data_->read(pass % 2 == 1 && !cyclic_ ? length_ - 1 - place : place);
    constexpr double kMaxGap = 0.1;  // [s]
    const auto truth = interpolate_at(data_->reference(), frame.stamp, kMaxGap);
    frame.index = index;
    frame.stamp = Timestamp::from_seconds(1 + period_ * static_cast<double>(index));
    frame.depth_stamp = frame.stamp;
    if (truth) reference_.push_back({frame.stamp, *truth});
    return frame;
  }

  /// The true poses of the frames that were read.
  [[nodiscard]] const std::vector<StampedPose>& reference() const { return reference_; }

 private:
  std::unique_ptr<Dataset> data_;
  bool cyclic_;
  std::size_t length_ = 0;
  double period_ = 0;  // [s]
  std::vector<StampedPose> reference_;
};

struct Pass {
  std::size_t number = 0;  // from 1
  std::size_t lost = 0;    // frames so far
  double cpu_seconds = 0;
  bool is_evaluated = false;
};

void print_row(const Pass& pass, const LongSequence& sequence, const Slam& slam) {
  constexpr double kThousand = 1e3;
  const double allocated = static_cast<double>(mallinfo2().uordblks) / kBytesOfMegabyte;
  const double resident = resident_megabytes();
  const GraphStatistics statistics = slam.statistics();
  std::string ate = "-";
  if (pass.is_evaluated) {
    const auto matches = associate(sequence.reference(), slam.trajectory().poses);
    ate = fmt::format("{:.1f}",
                      kThousand * absolute_trajectory_error(matches).statistics.translation.rmse);
  }
  const PoseGraph graph = slam.pose_graph();
  fmt::print("| {} | {} | {} | {} | {} | {} | {:.1f} | {:.1f} | {:.0f} | {:.1f} | {} |\n",
             pass.number, pass.number * sequence.length(), pass.lost, graph.nodes().size(),
             graph.edges().size(), statistics.redundant_keyframes + statistics.dropped_keyframes,
             static_cast<double>(statistics.keyframe_bytes) / kBytesOfMegabyte, allocated, resident,
             kThousand * pass.cpu_seconds / static_cast<double>(sequence.length()), ate);
  std::fflush(stdout);
}

void soak(const Arguments& arguments) {
  LongSequence sequence(arguments);
  Slam slam(sequence.camera(), arguments.options);
  fmt::print(
      "| pass | frames | lost | keyframes | edges | removed | keyframes MB | allocated MB | "
      "resident MB | CPU ms a frame | ATE mm |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n");
  const auto passes = static_cast<std::size_t>(arguments.passes);
  Pass pass;
  while (pass.number++ < passes) {
    const double start = process_cpu_seconds();
    for (std::size_t i = (pass.number - 1) * sequence.length(); i < pass.number * sequence.length();
         ++i) {
      pass.lost += slam.track(sequence.read(i)).status == TrackingStatus::kLost ? 1 : 0;
    }
    pass.cpu_seconds = process_cpu_seconds() - start;
    pass.is_evaluated = pass.number == 1 || pass.number == passes;
    if (pass.is_evaluated || pass.number % static_cast<std::size_t>(arguments.rows_every) == 0) {
      print_row(pass, sequence, slam);
    }
  }
}

}  // namespace
}  // namespace cvo_slam

// NOLINTNEXTLINE(bugprone-exception-escape): options that are defined wrongly throw, no others
int main(int argc, char** argv) {
  cvo_slam::Arguments arguments;
  bool keep_all = false;
  CLI::App app("Plays a recording forwards and backwards, again and again, as one long sequence");
  app.add_option("sequence", arguments.sequence)->required();
  app.add_option("--passes", arguments.passes, "Number of times that it is played");
  app.add_option("--rows-every", arguments.rows_every, "Prints a row after so many passes")
      ->check(CLI::PositiveNumber);
  app.add_option("--frames", arguments.frames, "Plays only the first frames; 0 = all");
  app.add_option("--max-memory", arguments.options.culling.max_memory, "As culling.max_memory");
  app.add_flag("--keep-all", keep_all, "Keeps redundant keyframes");
  app.add_flag("--cyclic", arguments.cyclic, "Plays forwards only: it ends where it began");
  CLI11_PARSE(app, argc, argv);
  arguments.options.culling.enabled = !keep_all;
  return cvo_slam::report_errors([&] { cvo_slam::soak(arguments); });
}
