// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What distinguishes a recorded camera from an ideal one. By default all effects are off, as in the
// preset "none". docs/reference/synthetic-sensor.md has the formulas and their sources.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "cvo_slam/core/options.h"

namespace cvo_slam::synthetic {

/// A structured-light depth camera.
struct DepthNoiseOptions {
  /// Factor on the Kinect's noise along the ray, in [0, 100]; 1 = a Kinect.
  double axial = 0;
  /// Factor on the Kinect's noise of the position of edges, in [0, 100]; 1 = a Kinect.
  double lateral = 0;
  /// Standard deviation of the Gaussian that smooths the noise over the image [px], in [0, 10].
  /// 0 = each pixel on its own. A Kinect matches windows, so that neighbours err alike: use 1.
  double correlation = 0;
  /// Step of the measured disparity [px], in [0, 4]; 0 = continuous. A Kinect has 1/8.
  double disparity_step = 0;
  /// True if a surface that is hidden from the infrared projector has no depth.
  bool shadows = false;
  /// Depth below this is missing [m], in [0, 1000]. For a Kinect: 0.5.
  double min_range = 0;
  /// Depth above this is missing [m], in [0, 1000]. For a Kinect: 5, beyond which its steps exceed
  /// 70 mm.
  double max_range = 1000;
  /// Depth at larger angles between ray and surface normal is missing [rad], in [0, pi/2]. For a
  /// Kinect: 1.4.
  double max_incidence = 0.5 * std::numbers::pi;
  /// Depth of surfaces that reflect a smaller share of light is missing, in [0, 1]. Off for a
  /// Kinect: what is dark to the eye is often bright in infrared.
  double min_reflectance = 0;
  /// Share of the pixels without depth for no reason in the scene, in [0, 0.95].
  double missing = 0;
  /// Factor on the measured depth, in [0.5, 2]: a sensor whose depth is calibrated badly.
  double scale = 1;
};

/// The chip of the colour camera.
struct ImageNoiseOptions {
  /// Standard deviation of the noise of a black pixel [grey levels], in [0, 100].
  double read = 0;
  /// Standard deviation of the shot noise of a white pixel [grey levels], in [0, 100].
  double shot = 0;
};

/// The exposure of both images.
struct ExposureOptions {
  /// Exposure time [s], in [0, 0.033]; 0 = an instant, without motion blur.
  double time = 0;
  /// Time from the first to the last row [s], in [0, 0.033]; 0 = all rows at once.
  double readout = 0;
  /// Standard deviation of slow changes of the exposure's logarithm, in [0, 2].
  double drift = 0;
  /// Time in which the exposure drifts from one value to an independent one [s], in [0.1, 1000].
  double drift_period = 4;
  /// Standard deviation of the exposure's logarithm between jumps of an automatic exposure, in
  /// [0, 2].
  double jump = 0;
  /// Mean time between jumps [s], in [0.1, 1000].
  double jump_interval = 4;
};

/// The stamps and the completeness of frames.
struct TimingOptions {
  /// Standard deviation of the difference between the stamps of depth and colour [s], in
  /// [0, 0.0117]. Larger values would pair images of different frames.
  double depth_jitter = 0;
  /// Time at which a depth image is taken after its stamp [s], in [-0.1, 0.1]: what a user would
  /// have to give as the depth offset. The depth stamps of fr1 are late: about -0.019.
  double depth_offset = 0;
  /// Frames a second [Hz], in [1, 1000].
  double frame_rate = 30;
  /// Share of frames without a colour image, in [0, 0.9].
  double drop_color = 0;
  /// Share of frames without a depth image, in [0, 0.9].
  double drop_depth = 0;
  /// Share of frames without both images, in [0, 0.9].
  double drop_both = 0;
};

/// Boxes that swing through the field of view.
struct MovingObjectOptions {
  int count = 0;       ///< number of boxes, in [0, 100]
  double size = 0.35;  ///< mean length of their edges [m], in [0.01, 10]; as a person's shoulders
  double speed = 0.5;  ///< largest speed [m/s], in [0, 100]; slower than people walk
};

/// The sensor that records a synthetic sequence.
struct SensorOptions {
  /// Seed of all noise of the sensor, together with the seed of the world. Another seed records the
  /// same world with other noise.
  int seed = 0;
  DepthNoiseOptions depth;      ///< errors and gaps of depth images
  ImageNoiseOptions image;      ///< noise of colour images
  ExposureOptions exposure;     ///< motion blur, rolling shutter, changes of brightness
  TimingOptions timing;         ///< stamps, frame rate, missing images
  MovingObjectOptions objects;  ///< what moves in front of the camera
};

///@{
/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(DepthNoiseOptions& options);
[[nodiscard]] OptionSet describe(ImageNoiseOptions& options);
[[nodiscard]] OptionSet describe(ExposureOptions& options);
[[nodiscard]] OptionSet describe(TimingOptions& options);
[[nodiscard]] OptionSet describe(MovingObjectOptions& options);
[[nodiscard]] OptionSet describe(SensorOptions& options);
///@}

/// Throws OptionError if an option is out of range or two options contradict each other.
void check(const SensorOptions& options);

/// Returns the preset "none", "kinect" (a first-generation Kinect in a living room) or "harsh"
/// (each effect about twice as strong, in bad light and among people). Throws OptionError for
/// another name; the message suggests the nearest one.
[[nodiscard]] SensorOptions sensor_preset(const std::string& name);
/// Returns the names that sensor_preset() knows.
[[nodiscard]] std::vector<std::string> sensor_preset_names();

}  // namespace cvo_slam::synthetic
