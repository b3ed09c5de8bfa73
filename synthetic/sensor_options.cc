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
           "Factor on the Kinect's axial noise, whose standard deviation at depth z and angle of "
           "incidence a is 0.0012 + 0.0019 (z - 0.4)^2 + 0.0001 / sqrt(z) (a / (pi/2 - a))^2 m "
           "(Nguyen, Izadi, Lovell, 3DIMPVT 2012). 1 = a Kinect; quantisation is part of it.")
      .add("lateral", o.lateral, {0, 100}, "",
           "Factor on the Kinect's lateral noise, by which edges are displaced: 0.8 + 0.035 a / "
           "(pi/2 - a) px (the same source). 1 = a Kinect.")
      .add("correlation", o.correlation, {0, 10}, "px",
           "Standard deviation of the Gaussian that smooths the noise over the image; 0 = each "
           "pixel on its own. The Kinect matches windows, so that neighbours err alike; with 1 "
           "pixels three apart are independent.")
      .add("disparity_step", o.disparity_step, {0, 4}, "px",
           "Disparity is measured in multiples of this, at a focal length of 580 px and a baseline "
           "of 0.075 m as the Kinect's, whatever the image's size; 0 = continuous. A Kinect has "
           "1/8: 3 mm at 1 m, 26 mm at 3 m.")
      .add("shadows", o.shadows,
           "No depth where something nearer hides a surface from the infrared projector, 0.075 m "
           "to the camera's right: to the left of near objects.")
      .add("min_range", o.min_range, {0, 1000}, "m",
           "No depth nearer than this. A Kinect's is 0.5 m.")
      .add("max_range", o.max_range, {0, 1000}, "m",
           "No depth farther than this. Beyond 5 m a Kinect's steps exceed 70 mm.")
      .add("max_incidence", o.max_incidence, {0, 0.5 * std::numbers::pi}, "rad",
           "No depth where the angle between the ray and the surface's normal is larger: the "
           "projected dots are too elongated to be matched. 1.4 = 80 deg for a Kinect.")
      .add("min_reflectance", o.min_reflectance, {0, 1}, "",
           "No depth on surfaces that reflect less, which return too little of the projector's "
           "light. Off for a Kinect: what is dark to the eye is often bright in infrared.")
      .add("missing", o.missing, {0, 0.95}, "",
           "Share of the pixels that lack depth for no reason in the scene, in patches of some 20 "
           "px that come and go with each frame. Of fr1/rpy 0.21 to 0.29 is missing for all "
           "reasons together.");
}

OptionSet describe(ImageNoiseOptions& o) {
  return OptionSet()
      .add("read", o.read, {0, 100}, "grey levels",
           "Standard deviation of the noise of a black pixel, each channel on its own.")
      .add("shot", o.shot, {0, 100}, "grey levels",
           "Standard deviation of the photons' noise at white; its variance is proportional to the "
           "light. 2.5 belongs to a full well of 10,000 electrons.");
}

OptionSet describe(ExposureOptions& o) {
  return OptionSet()
      .add("time", o.time, {0, 0.033}, "s",
           "Light is collected so long about the stamp, by which moving images are blurred: the "
           "average of instants in steps of about a pixel. 0 = an instant.")
      .add("readout", o.readout, {0, 0.033}, "s",
           "Time from the first to the last row of both images; the stamp and the true pose are "
           "those of the middle of the image. A rolling shutter as the Kinect's needs most of the "
           "frame period; 0 = all rows at once.")
      .add("drift", o.drift, {0, 2}, "",
           "Standard deviation of slow changes of the exposure's logarithm.")
      .add("drift_period", o.drift_period, {0.1, 1000}, "s",
           "The exposure drifts from one value to an independent one in this time.")
      .add("jump", o.jump, {0, 2}, "",
           "Standard deviation of the logarithm of the levels between which an automatic exposure "
           "jumps. 0.2 = one fifth brighter or darker.")
      .add("jump_interval", o.jump_interval, {0.1, 1000}, "s", "Mean time between such jumps.");
}

OptionSet describe(TimingOptions& o) {
  return OptionSet()
      .add("depth_jitter", o.depth_jitter, {0, 0.0117}, "s",
           "Standard deviation of the difference of the stamps of the depth and the colour image, "
           "at most sqrt(2) times that: the two cameras have no common clock. 0.0117 on fr1/rpy; "
           "more would pair images with another frame's. The depth image is what is seen at its "
           "own stamp.")
      .add("drop_color", o.drop_color, {0, 0.9}, "", "Share of frames without a colour image.")
      .add("drop_depth", o.drop_depth, {0, 0.9}, "", "Share of frames without a depth image.")
      .add("drop_both", o.drop_both, {0, 0.9}, "",
           "Share of frames without either. The first frame is never dropped.");
}

OptionSet describe(MovingObjectOptions& o) {
  return OptionSet()
      .add("count", o.count, {0, 100}, "", "Boxes that swing through the view.")
      .add("size", o.size, {0.01, 10}, "m",
           "Mean length of their edges: about that of a person's "
           "shoulders.")
      .add("speed", o.speed, {0, 100}, "m/s", "Their largest speed. Slower than people walk.");
}

OptionSet describe(SensorOptions& o) {
  return OptionSet()
      .add("seed", o.seed, {0}, "",
           "Of all that is random about the sensor, together with the world's seed: another one "
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
