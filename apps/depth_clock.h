// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/io/followed_dataset.h"
#include "cvo_slam/slam/depth_offset.h"

namespace cvo_slam {

/// The depth offset that a sequence is read with, and where it comes from.
struct DepthClock {
  double seconds = 0;
  std::optional<DepthOffset> measurement;  ///< empty if it was not measured
  std::string origin;                      ///< for people

  /// Returns "-18.9 ms (measured on 250 frames, +- 0.8 ms)".
  [[nodiscard]] std::string text() const;
};

/// A sequence, with its images paired by its depth offset.
struct TimedSequence {
  std::unique_ptr<Dataset> data;
  DepthClock clock;
};

/// Opens a sequence with the depth offset that --depth-offset gives, else with that of the camera,
/// else measured on the recording (if its colour and depth stamps differ, or --depth-offset is
/// `measure`).
[[nodiscard]] TimedSequence open_timed(const DatasetArguments& arguments,
                                       const TrackerOptions& tracker);

/// Opens a sequence in the same way, but measures nothing: where the offset would be measured, it
/// is 0.
[[nodiscard]] TimedSequence open_untimed(const DatasetArguments& arguments);

/// A recording that is still being made, with its images paired by its depth offset.
struct FollowedSequence {
  std::shared_ptr<const Dataset> data;  ///< what `frames` has returned
  std::shared_ptr<FrameSource> frames;
  DepthClock clock;
};

/// Waits for the first frames of a recording, or opens standard input if its folder is "-", with
/// the depth offset that --depth-offset gives, else with that of the camera; it cannot be measured
/// yet. Throws OptionError if it was to be measured.
[[nodiscard]] FollowedSequence open_followed(const DatasetArguments& arguments,
                                             const FollowOptions& options);

}  // namespace cvo_slam
