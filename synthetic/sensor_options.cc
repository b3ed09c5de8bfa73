// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/sensor_options.h"

#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam::synthetic {
namespace {

SensorOptions kinect() {
  SensorOptions o;
  o.depth = {.axial = 1,
             .lateral = 1,
             .correlation = 1,
             .disparity_step = 0.125,
             .shadows = true,
             .min_range = 0.5,
             .max_range = 5,
             .max_incidence = 1.4,
             .min_reflectance = 0,
             .missing = 0};
  o.image = {.read = 1, .shot = 2.5};
  o.exposure = {.time = 0.008,
                .readout = 0.026,
                .drift = 0.03,
                .drift_period = 4,
                .jump = 0,
                .jump_interval = 4};
  o.timing.depth_jitter = 0.011;
  return o;
}

SensorOptions harsh() {
  SensorOptions o = kinect();
  o.depth.axial = 2;
  o.depth.lateral = 2;
  o.depth.max_range = 3.5;
  o.depth.max_incidence = 1.3;
  o.depth.min_reflectance = 0.08;
  o.depth.missing = 0.2;
  o.image = {.read = 4, .shot = 6};
  o.exposure.time = 0.025;
  o.exposure.drift = 0.1;
  o.exposure.jump = 0.2;
  o.exposure.jump_interval = 3;
  o.timing.drop_color = 0.02;
  o.timing.drop_depth = 0.02;
  o.timing.drop_both = 0.02;
  o.objects.count = 3;
  return o;
}

using Presets = std::vector<std::pair<std::string, SensorOptions>>;

Presets presets() { return {{"none", {}}, {"kinect", kinect()}, {"harsh", harsh()}}; }

}  // namespace

OptionSet describe(DepthNoiseOptions& o) {
  return OptionSet()
      .add("axial", o.axial, {0, 100}, "",
           "Factor on the Kinect's noise along the ray; 1 = a Kinect. Its standard deviation at "
           "depth z and angle of incidence a is 0.0012 + 0.0019 (z - 0.4)^2 + 0.0001 / sqrt(z) "
           "(a / (pi/2 - a))^2 m, including quantisation (Nguyen, Izadi, Lovell, 3DIMPVT 2012).")
      .add("lateral", o.lateral, {0, 100}, "",
           "Factor on the Kinect's noise of the position of edges; 1 = a Kinect. Its standard "
           "deviation is 0.8 + 0.035 a / (pi/2 - a) px (the same source).")
      .add("correlation", o.correlation, {0, 10}, "px",
           "Standard deviation of the Gaussian that smooths the noise over the image; 0 = each "
           "pixel on its own. A Kinect matches windows, so that neighbours err alike; with 1, "
           "pixels three apart are independent.")
      .add(
          "disparity_step", o.disparity_step, {0, 4}, "px",
          "Step of the measured disparity, for the Kinect's focal length of 580 px and baseline of "
          "0.075 m at any image size; 0 = continuous. A Kinect has 1/8: 3 mm at 1 m, 26 mm at "
          "3 m.")
      .add("shadows", o.shadows,
           "Depth is missing if a nearer object hides the surface from the infrared projector, "
           "which is 0.075 m to the right of the camera. Shadows are to the left of near objects.")
      .add("min_range", o.min_range, {0, 1000}, "m",
           "Depth below this is missing. For a Kinect: 0.5 m.")
      .add("max_range", o.max_range, {0, 1000}, "m",
           "Depth above this is missing. For a Kinect: 5 m, beyond which its steps exceed 70 mm.")
      .add("max_incidence", o.max_incidence, {0, 0.5 * std::numbers::pi}, "rad",
           "Depth at larger angles between ray and surface normal is missing, because the "
           "projected dots are too elongated to be matched. For a Kinect: 1.4 = 80 deg.")
      .add("min_reflectance", o.min_reflectance, {0, 1}, "",
           "Depth of surfaces that reflect a smaller share of light is missing. Off for a Kinect: "
           "what is dark to the eye is often bright in infrared.")
      .add(
          "missing", o.missing, {0, 0.95}, "",
          "Share of the pixels without depth for no reason in the scene, in patches of about 20 px "
          "that change with each frame. In fr1/rpy, 0.21 to 0.29 is missing for all reasons "
          "together.")
      .add("scale", o.scale, {0.5, 2}, "",
           "Factor on the measured depth: a sensor whose depth is calibrated badly.");
}

OptionSet describe(ImageNoiseOptions& o) {
  return OptionSet()
      .add("read", o.read, {0, 100}, "grey levels",
           "Standard deviation of the noise of a black pixel, independent in each channel.")
      .add("shot", o.shot, {0, 100}, "grey levels",
           "Standard deviation of the shot noise of a white pixel; its variance is proportional to "
           "the light. 2.5 corresponds to a full well of 10,000 electrons.");
}

OptionSet describe(ExposureOptions& o) {
  return OptionSet()
      .add("time", o.time, {0, 0.033}, "s",
           "Exposure time, centred at the stamp. It blurs moving images: they are the average of "
           "instants in steps of about a pixel. 0 = an instant.")
      .add("readout", o.readout, {0, 0.033}, "s",
           "Time from the first to the last row of both images; stamp and true pose are those of "
           "the middle of the image. The rolling shutter of a Kinect takes most of the frame "
           "period; 0 = all rows at once.")
      .add("drift", o.drift, {0, 2}, "",
           "Standard deviation of slow changes of the exposure's logarithm.")
      .add("drift_period", o.drift_period, {0.1, 1000}, "s",
           "Time in which the exposure drifts from one value to an independent one.")
      .add("jump", o.jump, {0, 2}, "",
           "Standard deviation of the exposure's logarithm between jumps of an automatic exposure. "
           "0.2 = one fifth brighter or darker.")
      .add("jump_interval", o.jump_interval, {0.1, 1000}, "s", "Mean time between jumps.");
}

OptionSet describe(TimingOptions& o) {
  return OptionSet()
      .add("depth_jitter", o.depth_jitter, {0, 0.0117}, "s",
           "Standard deviation of the difference between the stamps of depth and colour, which is "
           "at most sqrt(2) times this: the two cameras have no common clock. 0.0117 on fr1/rpy; "
           "larger values would pair images of different frames. The depth image shows the scene "
           "at its own stamp.")
      .add("depth_offset", o.depth_offset, {-0.1, 0.1}, "s",
           "Time at which a depth image is taken after its stamp: what `run --depth-offset` has to "
           "be given. The depth stamps of fr1 are late: about -0.019.")
      .add("frame_rate", o.frame_rate, {1, 1000}, "Hz", "Frames a second.")
      .add("drop_color", o.drop_color, {0, 0.9}, "", "Share of frames without a colour image.")
      .add("drop_depth", o.drop_depth, {0, 0.9}, "", "Share of frames without a depth image.")
      .add("drop_both", o.drop_both, {0, 0.9}, "",
           "Share of frames without both images. The first frame is never dropped.");
}

OptionSet describe(MovingObjectOptions& o) {
  return OptionSet()
      .add("count", o.count, {0, 100}, "", "Number of boxes that swing through the field of view.")
      .add("size", o.size, {0.01, 10}, "m",
           "Mean length of their edges. 0.35 is about the width of a person's shoulders.")
      .add("speed", o.speed, {0, 100}, "m/s",
           "Largest speed of the boxes. 0.5 is slower than people walk.");
}

OptionSet describe(SensorOptions& o) {
  return OptionSet()
      .add("seed", o.seed, {0}, "",
           "Seed of all noise of the sensor, together with the seed of the world. Another seed "
           "records the same world with other noise.")
      .add("depth", describe(o.depth))
      .add("image", describe(o.image))
      .add("exposure", describe(o.exposure))
      .add("timing", describe(o.timing))
      .add("objects", describe(o.objects));
}

void check(const SensorOptions& options) {
  SensorOptions copy = options;
  OptionSet().add("sensor", describe(copy)).check();
  if (options.depth.min_range >= options.depth.max_range) {
    throw OptionError(fmt::format("sensor.depth.min_range={} must be less than max_range={}",
                                  options.depth.min_range, options.depth.max_range));
  }
}

SensorOptions sensor_preset(const std::string& name) {
  for (const auto& [candidate, options] : presets()) {
    if (candidate == name) return options;
  }
  throw OptionError(
      fmt::format("noise '{}' is unknown; {}", name, suggestion(name, sensor_preset_names())));
}

std::vector<std::string> sensor_preset_names() {
  std::vector<std::string> names;
  for (const auto& preset : presets()) names.push_back(preset.first);
  return names;
}

}  // namespace cvo_slam::synthetic
