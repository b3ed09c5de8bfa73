// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The clock between colour and depth: the depth stamps of many cameras are late or early by tens of
// milliseconds, which a moving camera sees as false geometry.
#pragma once

#include <cstddef>
#include <string>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/frame_source.h"
#include "cvo_slam/frontend/tracker.h"

namespace cvo_slam {

/// How the depth offset of a recording is measured.
struct DepthOffsetOptions {
  double start = 0;         ///< the offset to start from [s]
  double max_offset = 0.1;  ///< an offset beyond this is not believed [s]
  /// Largest standard deviation of an offset that is used [s]. Accuracy gains from an offset that
  /// is known to 4 ms; one known worse may be as wrong as none.
  double max_uncertainty = 0.004;
  /// Standard deviation at which no more frames are looked at [s].
  double enough = 0.0005;
  std::size_t min_frames = 200;   ///< frames that are always looked at, if there are as many
  std::size_t max_frames = 1000;  ///< frames after which the search ends in any case
  /// Time that is looked at, if the recording is as long, once the offset has settled [s]:
  /// stretches of a few seconds are less independent than the jackknife takes them for.
  double settled_time = 20;
};

/// A measured depth offset.
struct DepthOffset {
  bool is_measured = false;  ///< false: the recording does not tell, and `seconds` is 0
  double seconds = 0;        ///< to be added to depth stamps [s]: Camera::depth_offset
  double uncertainty = 0;    ///< standard deviation [s]; 0 if it could not be told
  std::size_t frames = 0;    ///< number of frames of the last round
  std::string reason;        ///< how it was found, or why not, in words
};

/// Measures what has to be added to the depth stamps of a recording, on its beginning: what the
/// colours and what the depths say about the motion between two frames differs by what the clock is
/// off, where the camera's velocity has changed. Images are then paired anew with that offset,
/// until it settles. The uncertainty is that of a jackknife over stretches of the recording; it is
/// large where the camera hardly moves. docs/theory/depth-clock.md. Throws what the source throws,
/// and OptionError for bad options.
[[nodiscard]] DepthOffset calibrate_depth_offset(const FramesPairedWith& open, const Camera& camera,
                                                 const TrackerOptions& tracker = {},
                                                 const DepthOffsetOptions& options = {});

}  // namespace cvo_slam
