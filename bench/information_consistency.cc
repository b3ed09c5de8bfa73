// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures how well the information matrices of registrations predict their errors: the normalised
// estimation error squared (NEES), e^T Omega e with e = log(T_true^-1 T_estimated), of each tracked
// frame against its keyframe. With six degrees of freedom its mean should be 6, and 95 % of the
// values should be below 12.59. Y. Bar-Shalom et al., "Estimation with Applications to Tracking and
// Navigation", 2001.
//   information_consistency [--set key=value]... sequence...
// The keys are those of the tracker: expert.registration.information_scale, ...
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {
namespace {

constexpr double kGate95 = 12.5916;  // chi squared, 6 degrees of freedom

/// Returns the pose with exactly this stamp, if there is one.
std::optional<SE3> pose_at(const std::vector<StampedPose>& reference, const Timestamp& stamp) {
  const auto it = std::lower_bound(
      reference.begin(), reference.end(), stamp,
      [](const StampedPose& pose, const Timestamp& time) { return pose.stamp < time; });
  if (it == reference.end() || it->stamp != stamp) return std::nullopt;
  return it->T_world_camera;
}

/// Returns the NEES of every frame that was registered against a keyframe.
std::vector<double> nees_of(const Dataset& data, const TrackerOptions& options) {
  Tracker tracker(data.camera(), options);
  std::vector<double> values;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const FrameRecord record = tracker.track(data.read(i)).record;
    if (record.status == TrackingStatus::kLost || record.keyframe == record.index) continue;
    const auto T_world_camera = pose_at(data.reference(), record.stamp);
    const auto T_world_keyframe = pose_at(data.reference(), data.stamp(record.keyframe));
    if (!T_world_camera || !T_world_keyframe) continue;
    const SE3 truth = T_world_keyframe->inverse() * *T_world_camera;
    const Vector6 error = (truth.inverse() * record.registration.T_fixed_moving).log();
    values.push_back(error.dot(inverse_of_spd(record.registration.covariance) * error));
  }
  return values;
}

void print_row(const std::string& name, std::vector<double> values) {
  if (values.empty()) throw DataError(name + ": no frame has an exact pose in the ground truth");
  double sum = 0;
  for (const double value : values) sum += value;
  const auto inside =
      std::count_if(values.begin(), values.end(), [](double value) { return value < kGate95; });
  const auto n = static_cast<double>(values.size());
  std::sort(values.begin(), values.end());
  fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.1f} |\n", name, values.size(), sum / n,
             values[values.size() / 2], 100 * static_cast<double>(inside) / n);
}

}  // namespace
}  // namespace cvo_slam

int main(int argc, char** argv) {
  return cvo_slam::report_errors([&] {
    cvo_slam::TrackerOptions options;
    const cvo_slam::OptionSet set = describe(options);
    fmt::print("| sequence | frames | mean NEES | median NEES | inside the 95 % gate [%] |\n");
    fmt::print("| --- | ---: | ---: | ---: | ---: |\n");
    for (int i = 1; i < argc; ++i) {
      const std::string_view argument = argv[i];
      if (argument == "--set" && i + 1 < argc) {
        const std::string_view setting = argv[++i];
        const std::size_t equals = std::min(setting.find('='), setting.size() - 1);
        set.set(std::string(setting.substr(0, equals)), std::string(setting.substr(equals + 1)));
        continue;
      }
      const auto data = cvo_slam::open_dataset(argument);
      cvo_slam::print_row(data->name(), cvo_slam::nees_of(*data, options));
    }
  });
}
