// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/sensor_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam::synthetic {
namespace {

std::string error_of(const SensorOptions& options) {
  try {
    check(options);
  } catch (const OptionError& error) {
    return error.what();
  }
  return "";
}

TEST(SensorPreset, AllAreValidAndTheIdealOneIsTheDefault) {
  EXPECT_THAT(sensor_preset_names(), ::testing::ElementsAre("none", "kinect", "harsh"));
  for (const auto& name : sensor_preset_names()) {
    EXPECT_EQ(error_of(sensor_preset(name)), "") << name;
  }
  SensorOptions none = sensor_preset("none");
  SensorOptions defaults;
  const OptionSet expected = describe(defaults);
  for (const auto& option : describe(none).options()) {
    EXPECT_EQ(option.get(), expected.get(option.key)) << option.key;
  }
}

TEST(SensorPreset, AnUnknownNameGetsTheNearestKnownOne) {
  try {
    static_cast<void>(sensor_preset("kinetc"));
    FAIL() << "no exception";
  } catch (const OptionError& error) {
    EXPECT_STREQ(error.what(), "noise 'kinetc' is unknown; did you mean 'kinect'?");
  }
}

TEST(SensorOptions, ImpossibleValuesAreRefused) {
  SensorOptions options;
  options.depth.axial = -1;
  EXPECT_EQ(error_of(options), "sensor.depth.axial=-1: the value must be 0 to 100");
  options = {};
  options.timing.depth_jitter = 0.02;  // would pair images of different frames
  EXPECT_EQ(error_of(options), "sensor.timing.depth_jitter=0.02: the value must be 0 to 0.0117");
  options = {};
  options.depth.min_range = 3;
  options.depth.max_range = 2;
  EXPECT_EQ(error_of(options), "sensor.depth.min_range=3 must be less than max_range=2");
}

TEST(SensorOptions, EachIsDocumented) {
  SensorOptions options;
  for (const auto& option : describe(options).options()) EXPECT_NE(option.doc, "") << option.key;
}

}  // namespace
}  // namespace cvo_slam::synthetic
