// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kGood = R"(ambient: 0.5
lights:
  - {position: [0, 0, 2], power: 1.5}
shapes:
  - box: [1, 2, 0.4]
    at: [0, 3, 0.5]
    material: oak
  - sheet: [2, 1]
    at: [0, 5, 1]
    facing: [0, 1, 0]
    material: {pattern: wood, scale: 0.3}
path:
  duration: 8
  viewpoints:
    - {position: [0, 0, 1], target: [0, 3, 1]}
    - {position: [0.2, 0, 1], target: [0, 3, 1]}
    - {position: [0.4, 0, 1], target: [0, 3, 1]}
    - {position: [0.2, 0.2, 1], target: [0, 3, 1]}
)";

/// The message for the good file with one part replaced.
std::string error_with(const std::string& part, const std::string& replacement) {
  std::string text = kGood;
  const auto at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  text.replace(at, part.size(), replacement);
  try {
    static_cast<void>(parse_world(text, "w.yaml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(WorldFileError, NoneInTheGoodFile) { EXPECT_EQ(error_with("oak", "oak"), "no error"); }

TEST(WorldFileError, AnUnknownShapeOrKeyGetsTheNearestName) {
  EXPECT_EQ(error_with("sheet: [2, 1]", "sheat: [2, 1]"),
            "w.yaml:8: shape: unknown key 'sheat'; did you mean 'sheet'?");
  EXPECT_EQ(error_with("ambient", "ambiant"),
            "w.yaml:1: world: unknown key 'ambiant'; did you mean 'ambient'?");
  EXPECT_EQ(error_with("power", "pover"),
            "w.yaml:3: light: unknown key 'pover'; did you mean 'power'?");
  EXPECT_THAT(error_with("  duration", "  durration"), HasSubstr("did you mean 'duration'?"));
}

TEST(WorldFileError, AnUnknownMaterialOrPatternGetsTheNearestName) {
  EXPECT_EQ(error_with("oak", "oac"), "w.yaml:7: material: 'oac' is unknown; did you mean 'oak'?");
  EXPECT_EQ(error_with("pattern: wood", "pattern: woot"),
            "w.yaml:11: pattern: 'woot' is unknown; did you mean 'wood'?");
}

TEST(WorldFileError, SizesMustBePositive) {
  EXPECT_EQ(error_with("[1, 2, 0.4]", "[1, -2, 0.4]"),
            "w.yaml:5: box: the size -2 must be positive");
  EXPECT_EQ(error_with("sheet: [2, 1]", "sphere: 0"), "w.yaml:8: sphere: 0 must be positive");
  EXPECT_THAT(error_with("scale: 0.3", "scale: -1"), HasSubstr("w.yaml:11: scale: -1 must be"));
  EXPECT_THAT(error_with("power: 1.5", "power: -1"), HasSubstr("w.yaml:3: power: -1 must not"));
  EXPECT_THAT(error_with("duration: 8", "duration: 0"), HasSubstr("w.yaml:13: duration: 0 must"));
}

// A world of 1e15 s, or as many metres, took all memory or all time.
TEST(WorldFileError, NumbersThatWouldTakeAllMemoryOrTimeAreRefused) {
  EXPECT_EQ(error_with("duration: 8", "duration: 1e15"),
            "w.yaml:13: duration: 1000000000000000 s at speed 1 are more than a day; give a "
            "shorter path");
  EXPECT_THAT(error_with("duration: 8", "duration: 8\n  speed: 1e-12"),
              HasSubstr("w.yaml:13: duration: 8 s at speed 1e-12 are more than a day"));
  EXPECT_EQ(error_with("[1, 2, 0.4]", "[1, 2e9, 0.4]"),
            "w.yaml:5: box: the size 2000000000 must be at most 10000 m");
  EXPECT_EQ(error_with("sheet: [2, 1]", "sphere: 1e300"),
            "w.yaml:8: sphere: the size 1e+300 must be at most 10000 m");
  EXPECT_EQ(error_with("position: [0.4, 0, 1]", "position: [1e12, 0, 1]"),
            "w.yaml:17: position: coordinates must be within 10000 m");
  EXPECT_THAT(error_with("scale: 0.3", "scale: 1e-300"),
              HasSubstr("w.yaml:11: scale: 1e-300 must"));
  EXPECT_THAT(error_with("    material: oak",
                         "    swing: {amplitude: [0, 1, 0], period: 1e-300}\n    material: oak"),
              HasSubstr("period: 1e-300 must be in"));
}

TEST(WorldFileError, NumbersMustBeNumbers) {
  EXPECT_EQ(error_with("[0, 3, 0.5]", "[0, three, 0.5]"), "w.yaml:6: at: expected a number");
  EXPECT_EQ(error_with("[0, 3, 0.5]", "[0, 3]"), "w.yaml:6: at: expected a list of 3 numbers");
  EXPECT_EQ(error_with("[0, 3, 0.5]", "[0, .nan, 0.5]"), "w.yaml:6: at: expected a number");
  EXPECT_THAT(error_with("material: oak", "material: oak\n    seed: 1.5"),
              HasSubstr("w.yaml:8: seed: 1.5 must be a whole number"));
  EXPECT_THAT(error_with("scale: 0.3", "contrast: 2"),
              HasSubstr("w.yaml:11: contrast: 2 must be in [0, 1]"));
  EXPECT_THAT(error_with("scale: 0.3", "base: [0, 2, 0]"), HasSubstr("must be in [0, 1]"));
}

TEST(WorldFileError, ValuesOfAnotherKindAreRefused) {
  EXPECT_EQ(error_with("duration: 8", "closed: maybe"),
            "w.yaml:13: path: the key 'duration' is missing");
  EXPECT_THAT(error_with("duration: 8", "duration: 8\n  closed: maybe"),
              HasSubstr("w.yaml:14: closed: expected true or false"));
  EXPECT_THAT(error_with("material: oak", "material: [oak]"),
              HasSubstr("w.yaml:7: material: expected 'key: value' entries"));
  EXPECT_THAT(error_with("lights:\n  - {position: [0, 0, 2], power: 1.5}", "lights: many"),
              HasSubstr("w.yaml:2: lights: expected a list"));
}

TEST(WorldFileError, WhatIsMissingIsNamed) {
  EXPECT_EQ(error_with("    material: oak\n", ""),
            "w.yaml:5: shape: the key 'material' is missing");
  EXPECT_EQ(error_with("    at: [0, 3, 0.5]\n", ""),
            "w.yaml:5: shape: give its position: 'at' (its centre) or 'on' (its foot)");
  EXPECT_EQ(error_with("box: [1, 2, 0.4]\n    at", "at"),
            "w.yaml:5: shape: give its kind and size: box, sheet, cylinder or sphere");
  EXPECT_THAT(error_with("path:", "paths:"), HasSubstr("unknown key 'paths'"));
  EXPECT_THAT(error_with("[0, 1, 0]", "[0, 0, 0]"), HasSubstr("must not be zero"));
}

TEST(WorldFileError, AmbiguousOrDistortedShapesAreRefused) {
  EXPECT_EQ(error_with("box: [1, 2, 0.4]", "box: [1, 2, 0.4]\n    sphere: 1"),
            "w.yaml:5: shape: give one of box, sheet, cylinder and sphere, not several");
  EXPECT_EQ(error_with("material: oak", "on: [0, 0, 0]\n    material: oak"),
            "w.yaml:5: shape: give one of at and on, not several");
  EXPECT_THAT(error_with("facing: [0, 1, 0]", "rotation: [[1, 0, 0], [0, 2, 0], [0, 0, 1]]"),
              HasSubstr("w.yaml:10: rotation: the rows must be orthonormal"));
}

TEST(WorldFileError, TooFewViewpointsAreCounted) {
  EXPECT_EQ(error_with("    - {position: [0.2, 0.2, 1], target: [0, 3, 1]}\n", ""),
            "w.yaml:15: camera path: 3 viewpoints are too few; give at least 4");
  EXPECT_THAT(error_with("target: [0, 3, 1]", "target: [0, 0, 3]"),
              HasSubstr("viewpoint 1 must not look straight up or down"));
}

TEST(WorldFileError, ACameraInsideAWallIsFoundWithItsTime) {
  const std::string message = error_with("position: [0.4, 0, 1]", "position: [0.4, 8, 1]");
  EXPECT_THAT(message, StartsWith("w.yaml:13: path: after "));
  EXPECT_THAT(message,
              HasSubstr("s the camera is inside or nearer than 0.05 m to the shape of line"));
  // From the beginning inside the box.
  EXPECT_THAT(error_with("at: [0, 3, 0.5]", "at: [0.2, 0, 1]"),
              StartsWith("w.yaml:13: path: after 0.00 s"));
}

TEST(WorldFileError, TheFileItselfMayBeMissingOrBroken) {
  EXPECT_THROW(static_cast<void>(read_world("/nowhere/w.yaml")), InputError);
  EXPECT_THAT(error_with("ambient: 0.5", "ambient: [0.5"), HasSubstr("not valid YAML"));
  EXPECT_EQ(error_with("at: [0, 3, 0.5]", "at: [0, 3, 0.5]\n    at: [0, 3, 0.5]"),
            "w.yaml:7: key 'at' is given twice; remove one");
}

TEST(WorldFileError, AnEmptyFileSaysWhatAWorldNeeds) {
  EXPECT_THROW(static_cast<void>(parse_world("", "w.yaml")), InputError);
}

}  // namespace
}  // namespace cvo_slam::synthetic
