// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "cvo_slam/core/options.h"

// What is not ideal about a recorded camera. Everything is off by default: the options of the
// preset "none". docs/reference/synthetic-sensor.md has the formulas and their sources.

namespace cvo_slam::synthetic {

/// Of a structured-light depth camera.
struct DepthNoiseOptions {
  double axial = 0;           ///< factor on the Kinect's noise along the ray
  double lateral = 0;         ///< factor on the Kinect's noise of the place of edges
  double correlation = 0;     ///< [px] of both
  double disparity_step = 0;  ///< [px]
  bool shadows = false;
  double min_range = 0;                           ///< [m]
  double max_range = 1000;                        ///< [m]
  double max_incidence = 0.5 * std::numbers::pi;  ///< [rad]
  double min_reflectance = 0;
  double missing = 0;
};

/// Of the colour camera's chip.
struct ImageNoiseOptions {
  double read = 0;  ///< [grey levels]
  double shot = 0;  ///< of a white pixel [grey levels]
};

/// When light is collected, and what becomes of it.
struct ExposureOptions {
  double time = 0;     ///< [s]
  double readout = 0;  ///< [s]
  double drift = 0;
  double drift_period = 4;  ///< [s]
  double jump = 0;
  double jump_interval = 4;  ///< [s]
};

struct TimingOptions {
  double depth_jitter = 0;  ///< [s]
  double drop_color = 0;
  double drop_depth = 0;
  double drop_both = 0;
};

/// Boxes that swing through the view.
struct MovingObjectOptions {
  int count = 0;
  double size = 0.35;  ///< [m]
  double speed = 0.5;  ///< [m/s]
};

struct SensorOptions {
  int seed = 0;
  DepthNoiseOptions depth;
  ImageNoiseOptions image;
  ExposureOptions exposure;
  TimingOptions timing;
  MovingObjectOptions objects;
};

[[nodiscard]] OptionSet describe(DepthNoiseOptions& options);
[[nodiscard]] OptionSet describe(ImageNoiseOptions& options);
[[nodiscard]] OptionSet describe(ExposureOptions& options);
[[nodiscard]] OptionSet describe(TimingOptions& options);
[[nodiscard]] OptionSet describe(MovingObjectOptions& options);
[[nodiscard]] OptionSet describe(SensorOptions& options);

/// Throws OptionError where an option is out of range, or two contradict one another.
void check(const SensorOptions& options);

/// "none", "kinect" (as a first-generation Kinect in a living room) or "harsh" (each effect about
/// twice as strong, in bad light and among people). Throws OptionError for another name; the
/// message gives the nearest one.
[[nodiscard]] SensorOptions sensor_preset(const std::string& name);
[[nodiscard]] std::vector<std::string> sensor_preset_names();

}  // namespace cvo_slam::synthetic
