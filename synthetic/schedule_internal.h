// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/synthetic/sensor.h"
#include "cvo_slam/synthetic/sensor_options.h"

namespace cvo_slam::synthetic {

/// The times of a frame, and which of its images are kept.
struct FrameTimes {
  Timestamp color;
  Timestamp depth;
  double depth_offset = 0;  ///< time at which the depth image is taken after its stamp [s]
  bool has_color = true;
  bool has_depth = true;

  /// Returns the times of the kept images in the time of the world, which begins with the first
  /// frame.
  [[nodiscard]] Exposure exposure() const;
};

/// Returns the first `frames` frames. Two schedules of the same options and seed
/// agree in the frames that both have.
[[nodiscard]] std::vector<FrameTimes> schedule(std::size_t frames, const SensorOptions& options,
                                               std::uint32_t world_seed);

/// Returns the stamps of the ground truth from the first frame to the last, in order and without
/// duplicates: 100 a second, and those of the kept colour images.
[[nodiscard]] std::vector<Timestamp> reference_stamps(const std::vector<FrameTimes>& frames);

/// Returns the time of the world at a stamp [s].
[[nodiscard]] double world_seconds(const Timestamp& stamp);

}  // namespace cvo_slam::synthetic
