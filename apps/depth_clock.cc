// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/depth_clock.h"

#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "cvo_slam/apps/sequence_run.h"
#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

/// The frames of a recording that was opened for them.
class OwnedFrames final : public FrameSource {
 public:
  explicit OwnedFrames(std::unique_ptr<Dataset> data)
      : data_(std::move(data)), frames_(*data_, 0, data_->size()) {}
  std::optional<RgbdFrame> next() override {
    if (InterruptGuard::requested()) return std::nullopt;
    return frames_.next();
  }

 private:
  std::unique_ptr<Dataset> data_;
  FramePrefetcher frames_;
};

/// Returns true if some depth image has another stamp than its colour image.
bool stamps_differ(const Dataset& data) {
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (data.stamp(i) != data.depth_stamp(i)) return true;
  }
  return false;
}

/// Returns why the offset of a sequence is not measured; empty if it is.
std::string reason_not_to_measure(const DatasetArguments& arguments, const Dataset& data,
                                  const TrackerOptions& tracker) {
  if (arguments.given_depth_offset()) return "given by --depth-offset";
  if (arguments.depth_offset == kMeasuredDepthOffset) return {};
  if (data.camera().depth_offset) return "of the camera";
  if (!stamps_differ(data)) return "colour and depth have the same stamps";
  if (!tracker.compensate_depth_delay) return "compensate_depth_delay is off";
  return {};
}

}  // namespace

std::string DepthClock::text() const {
  return fmt::format("{:+.1f} ms ({})", 1e3 * seconds, origin);
}

TimedSequence open_untimed(const DatasetArguments& arguments) {
  TimedSequence result{arguments.open(), {}};
  result.clock.seconds = result.data->camera().depth_offset.value_or(0);
  result.clock.origin = reason_not_to_measure(arguments, *result.data, TrackerOptions());
  if (result.clock.origin.empty()) result.clock.origin = "not measured";
  return result;
}

TimedSequence open_timed(const DatasetArguments& arguments, const TrackerOptions& tracker) {
  TimedSequence result{arguments.open(), {}};
  DepthClock& clock = result.clock;
  clock.seconds = result.data->camera().depth_offset.value_or(0);
  clock.origin = reason_not_to_measure(arguments, *result.data, tracker);
  if (!clock.origin.empty()) return result;
  const auto open = [&](double depth_offset) {
    return std::make_unique<OwnedFrames>(arguments.open(depth_offset));
  };
  clock.measurement = calibrate_depth_offset(open, result.data->camera(), tracker);
  clock.origin = clock.measurement->reason;
  clock.seconds = clock.measurement->seconds;
  if (clock.measurement->is_measured) result.data = arguments.open(clock.seconds);
  return result;
}

FollowedSequence open_followed(const DatasetArguments& arguments, const FollowOptions& options) {
  if (arguments.depth_offset == kMeasuredDepthOffset) {
    throw OptionError(
        "--depth-offset measure needs a whole recording, and this one is still being made; give "
        "the offset in seconds");
  }
  const DatasetOptions dataset_options = arguments.dataset_options();
  FollowedSequence result;
  const auto open = [&result](auto data) {
    result.data = data;
    result.frames = std::move(data);
  };
  if (arguments.is_pipe()) {
    open(std::make_shared<PipedDataset>(STDIN_FILENO, dataset_options, options.stop));
  } else {
    open(std::make_shared<FollowedDataset>(arguments.dataset, dataset_options, options));
  }
  const auto& offset = result.data->camera().depth_offset;
  result.clock.seconds = offset.value_or(0);
  result.clock.origin = arguments.given_depth_offset() ? "given by --depth-offset"
                        : offset                       ? "of the camera"
                                                       : "not measured";
  return result;
}

}  // namespace cvo_slam
