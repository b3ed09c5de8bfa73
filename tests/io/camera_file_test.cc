// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/camera_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The keys that every camera needs; they are seven lines.
constexpr const char* kGood =
    "width: 640\nheight: 480\nfx: 500\nfy: 501\ncx: 320\ncy: 240\ndepth_scale: 1000\n";

Camera read_text(const std::string& text) {
  const TemporaryFolder folder;
  return read_camera(folder.write("test.yaml", text));
}

std::string read_error(const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.write("c.yaml", text);
  return input_error(folder.path(), [&] { return read_camera(file); });
}

void expect_equal(const PinholeCamera& a, const PinholeCamera& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.fx, b.fx);
  EXPECT_EQ(a.fy, b.fy);
  EXPECT_EQ(a.cx, b.cx);
  EXPECT_EQ(a.cy, b.cy);
  EXPECT_EQ(a.distortion, b.distortion);
}

TEST(ReadCamera, NamesACameraByItsFile) {
  const Camera camera = read_text(kGood);
  EXPECT_EQ(camera.name, "test");
  EXPECT_EQ(camera.color.fy, 501);
  EXPECT_EQ(camera.depth_scale, 1000);
  EXPECT_FALSE(camera.color.has_distortion());
  EXPECT_FALSE(camera.depth);
}

TEST(ReadCamera, ReadsWhatWriteCameraWrote) {
  Camera camera = builtin_camera("tum_fr1");
  camera.name = "odd: name # 1";
  camera.depth_scale = 1 / 0.3;  // needs all its digits
  camera.noise = {0.1 / 3, 0.2 / 3, 0.7 / 3};
  camera.depth = DepthCamera{builtin_camera("icl_nuim").color,
                             SE3::exp((Vector6() << 0.01, -0.02, 0.03, 0.1, 0.2, 0.3).finished())};
  const TemporaryFolder folder;
  write_camera(folder.path() / "c.yaml", camera);
  const Camera again = read_camera(folder.path() / "c.yaml");
  EXPECT_EQ(again.name, camera.name);
  EXPECT_EQ(again.depth_scale, camera.depth_scale);
  EXPECT_EQ(again.readout_time, camera.readout_time);
  EXPECT_EQ(again.depth_offset, camera.depth_offset);
  EXPECT_EQ(again.noise.depth_floor, camera.noise.depth_floor);
  EXPECT_EQ(again.noise.depth_quadratic, camera.noise.depth_quadratic);
  EXPECT_EQ(again.noise.pixel, camera.noise.pixel);
  expect_equal(again.color, camera.color);
  ASSERT_TRUE(again.depth);
  expect_equal(again.depth->pinhole, camera.depth->pinhole);
  const SE3 difference = again.depth->T_color_depth.inverse() * camera.depth->T_color_depth;
  // Rounding the rotation to the nearest proper one moves it by a few units in the last place.
  EXPECT_LT(difference.log().norm(), 1e-14);
}

TEST(ReadCamera, KnowsTheReadoutTimeOfARollingShutter) {
  EXPECT_EQ(find_camera("tum_fr1").readout_time, 0.026);
  EXPECT_EQ(find_camera("icl_nuim").readout_time, 0);
  EXPECT_FALSE(find_camera("tum_fr1").depth_offset);
  EXPECT_NE(read_error(std::string(kGood) + "depth_offset: 2000000\n").find("depth_offset=2000000"),
            std::string::npos);
  EXPECT_NE(read_error(std::string(kGood) + "readout_time: -1\n").find("readout_time=-1"),
            std::string::npos);
}

TEST(ReadCamera, ReadsTheNoiseOfTheSensor) {
  const std::string good = kGood;
  const SensorNoise standard;
  const SensorNoise none = read_text(good).noise;
  EXPECT_EQ(none.depth_floor, standard.depth_floor);
  EXPECT_EQ(none.depth_quadratic, standard.depth_quadratic);
  EXPECT_EQ(none.pixel, standard.pixel);
  const SensorNoise all =
      read_text(good + "noise: {depth_floor: 0.01, depth_quadratic: 0, pixel: 0.5}\n").noise;
  EXPECT_EQ(all.depth_floor, 0.01);
  EXPECT_EQ(all.depth_quadratic, 0);
  EXPECT_EQ(all.pixel, 0.5);
  const SensorNoise one = read_text(good + "noise:\n  pixel: 2\n").noise;
  EXPECT_EQ(one.depth_floor, standard.depth_floor);
  EXPECT_EQ(one.pixel, 2);
}

TEST(ReadCamera, NamesTheLineOfAMistakeInTheNoise) {
  const std::string good = std::string(kGood) + "noise:\n";
  EXPECT_EQ(read_error(good + "  pixel: 1\n  depth_flor: 1\n"),
            "c.yaml:10: noise: unknown key 'depth_flor'; did you mean 'depth_floor'?");
  EXPECT_EQ(read_error(good + "  depth_floor: -0.001\n"),
            "c.yaml:9: depth_floor: -0.001 must not be negative");
  EXPECT_EQ(read_error(good + "  pixel: small\n"), "c.yaml:9: pixel: expected a number");
  EXPECT_EQ(read_error(good), "c.yaml:8: noise: a value is missing");
}

TEST(ReadCamera, NamesTheLineOfAMistake) {
  const std::string good = kGood;
  EXPECT_EQ(read_error(good + "focal: 3\n"),
            "c.yaml:8: camera: unknown key 'focal'; there are: name, depth_scale, readout_time, "
            "depth_offset, noise, depth, width, height, fx, fy, cx, cy, distortion");
  EXPECT_EQ(read_error(good + "hight: 3\n"),
            "c.yaml:8: camera: unknown key 'hight'; did you mean 'height'?");
  EXPECT_EQ(read_error(good + "fx: 3\n"), "c.yaml:8: key 'fx' is given twice; remove one");
  EXPECT_EQ(read_error(good + "distortion: [1, 2]\n"),
            "c.yaml:8: distortion: expected a list of 5 numbers");
  EXPECT_EQ(read_error("width: 640\nheight: 480.5\n"),
            "c.yaml:2: height: expected a number of pixels");
  EXPECT_EQ(read_error("width: 64\nheight: 48\nfx: wide\n"), "c.yaml:3: fx: expected a number");
  EXPECT_EQ(read_error("width: 64\nheight: 48\nfx: .nan\n"), "c.yaml:3: fx: expected a number");
  EXPECT_THAT(read_error("width: 64\nheight: 48\n"), HasSubstr("camera: the key 'fx' is missing"));
  EXPECT_EQ(read_error("width: 64\nheight:\nfx: 3\n"), "c.yaml:2: height: a value is missing");
  EXPECT_THAT(read_error("width: [1\n"), HasSubstr("c.yaml:2: not valid YAML"));
  EXPECT_THAT(read_error("- 1\n- 2\n"), HasSubstr("c.yaml:1: expected 'key: value' lines"));
  EXPECT_THAT(read_error(""), HasSubstr("is empty"));
  EXPECT_THAT(read_error(good + "depth: 5\n"),
              HasSubstr("c.yaml:8: depth: expected 'key: value' entries"));
  EXPECT_THROW(static_cast<void>(read_camera("/nowhere/c.yaml")), InputError);
}

TEST(ReadCamera, RefusesImpossibleValues) {
  std::string text = kGood;
  text.replace(text.find("fx: 500"), 7, "fx: 0");
  EXPECT_THAT(read_error(text), HasSubstr("fx > 0"));
}

TEST(ReadCamera, RefusesAPoseThatIsNotRigid) {
  const std::string depth =
      std::string(kGood) +
      "depth:\n  width: 64\n  height: 48\n  fx: 50\n  fy: 50\n  cx: 31\n  cy: 23\n";
  const std::string rows = "    - [0, 1, 0, 0]\n    - [0, 0, 1, 0]\n    - [0, 0, 0, 1]\n";
  const std::string key = "  T_color_depth:\n";
  EXPECT_EQ(read_error(depth + key + "    - [1, 0, 0, 0.1]\n" + rows), "no error");
  EXPECT_THAT(read_error(depth + key + "    - [2, 0, 0, 0.1]\n" + rows), HasSubstr("rigid 4x4"));
  EXPECT_THAT(read_error(depth + key + "    - [-1, 0, 0, 0.1]\n" + rows), HasSubstr("rigid 4x4"));
  EXPECT_THAT(read_error(depth + key + rows), HasSubstr("rigid 4x4"));
  EXPECT_THAT(read_error(depth), HasSubstr("'T_color_depth' is missing"));
}

TEST(ReadCamera, ReadsTheKeysOfOrbSlam2) {
  const Camera camera = read_text(
      "%YAML:1.0\n\n# Camera Parameters\nCamera.fx: 517.3\nCamera.fy: 516.5\nCamera.cx: 318.6\n"
      "Camera.cy: 255.3\nCamera.k1: 0.26\nCamera.k2: -0.95\nCamera.p1: -0.005\nCamera.p2: 0.002\n"
      "Camera.k3: 1.16\nCamera.width: 640\nCamera.height: 480\nCamera.bf: 40.0\n"
      "DepthMapFactor: 5000.0\nORBextractor.nFeatures: 1000\n");
  EXPECT_EQ(camera.color.fx, 517.3);
  EXPECT_EQ(camera.color.cy, 255.3);
  EXPECT_THAT(camera.color.distortion, ElementsAre(0.26, -0.95, -0.005, 0.002, 1.16));
  EXPECT_EQ(camera.depth_scale, 5000);
}

TEST(ReadCamera, ReadsTheKeysOfOrbSlam3) {
  const Camera camera = read_text(
      "%YAML:1.0\n---\nFile.version: \"1.0\"\nCamera.type: \"PinHole\"\nCamera1.fx: 535.4\n"
      "Camera1.fy: 539.2\nCamera1.cx: 320.1\nCamera1.cy: 247.6\nCamera.width: 640\n"
      "Camera.height: 480\nRGBD.DepthMapFactor: 5208.0\n");
  EXPECT_EQ(camera.color.fy, 539.2);
  EXPECT_FALSE(camera.color.has_distortion());
  EXPECT_EQ(camera.depth_scale, 5208);
}

TEST(ReadCamera, RefusesOrbSlamFilesThatItCannotFollow) {
  EXPECT_THAT(read_error("%YAML:1.0\nCamera.type: KannalaBrandt8\nCamera.fx: 5\n"),
              HasSubstr("c.yaml:2: Camera.type: only PinHole"));
  EXPECT_THAT(read_error("Camera.fx: 5\nCamera.height: 3\n"),
              HasSubstr("'Camera.width' is missing"));
}

/// The settings of ORB-SLAM2 for TUM fr3; they are eight lines.
constexpr const char* kSettings =
    "%YAML:1.0\nCamera.fx: 535.4\nCamera.fy: 539.2\nCamera.cx: 320.1\nCamera.cy: 247.6\n"
    "Camera.width: 640\nCamera.height: 480\nDepthMapFactor: 5000.0\n";

// Camera.k4 to k6 (a rational lens) were ignored without a word: 0.1 m in place of 0.003.
TEST(ReadCamera, RefusesKeysOfSettingsThatChangeTheLens) {
  const std::string good = kSettings;
  for (const char* key : {"k4", "k5", "k6", "bFishEye"}) {
    const std::string name = std::string("Camera.") + key;
    EXPECT_EQ(read_error(good + name + ": 0.0\n"), "no error");
    EXPECT_THAT(read_error(good + name + ": 1\n"),
                HasSubstr("c.yaml:9: " + name + ": 1 is a lens"));
  }
  EXPECT_THAT(read_error(good + "Camera1.k4: 0.1\n"), HasSubstr("c.yaml:9: Camera1.k4: 0.1 is"));
  for (const char* model : {"fisheye", "KannalaBrandt8", "Rectified", "equirectangular"}) {
    for (const char* key : {"Camera.model", "Camera.type"}) {
      const std::string line = fmt::format("{}: \"{}\"\n", key, model);
      EXPECT_THAT(read_error(good + "Camera.k4: 1\n" + line),
                  HasSubstr(std::string("c.yaml:10: ") + key + ": only PinHole (perspective) is"));
    }
  }
  EXPECT_EQ(read_error(good + "Camera.model: perspective\n"), "no error");
  EXPECT_EQ(read_error(good + "Camera.type: \"PinHole\"\n"), "no error");
}

TEST(ReadCamera, RefusesSettingsOfOtherImagesAndSensors) {
  const std::string good = kSettings;
  EXPECT_EQ(read_error(good + "Camera.setup: RGBD\n"), "no error");
  EXPECT_THAT(read_error(good + "Camera.setup: stereo\n"),
              HasSubstr("c.yaml:9: Camera.setup: only RGBD is supported, not 'stereo'"));
  EXPECT_EQ(read_error(good + "Camera.newWidth: 640\nCamera.imageScale: 1.0\n"), "no error");
  EXPECT_THAT(read_error(good + "Camera.newWidth: 320\n"),
              HasSubstr("c.yaml:9: Camera.newWidth: images are not resized"));
  EXPECT_THAT(read_error(good + "Camera.newHeight: 240\n"), HasSubstr("Camera.newHeight: images"));
  EXPECT_THAT(read_error(good + "Camera.imageScale: 0.5\n"), HasSubstr("Camera.imageScale: im"));
  EXPECT_THAT(read_error(good + "Camera2.fx: 500\n"),
              HasSubstr("c.yaml:9: 'Camera2.fx' is of a stereo camera"));
  EXPECT_THAT(read_error(good + "Stereo.T_c1_c2: [1]\n"), HasSubstr("is of a stereo camera"));
  EXPECT_THAT(read_error(good + "Camera1.fx: 500\n"),
              HasSubstr("c.yaml:9: 'Camera1.fx' is one of Camera.fx, Camera1.fx, and the file has "
                        "another"));
}

TEST(ReadCamera, RefusesUnknownKeysOfTheCameraByName) {
  const std::string good = kSettings;
  for (const char* key : {"Camera.s1", "Camera.skew", "Camera.lappingBegin", "Camera1.xi"}) {
    EXPECT_EQ(read_error(good + key + ": 1\n"),
              std::string("c.yaml:9: unknown key '") + key +
                  "'; remove it if it does not change the lens or the images");
  }
}

TEST(ReadCamera, SkipsKeysThatDoNotChangeTheCamera) {
  EXPECT_EQ(read_error(std::string(kSettings) +
                       "Camera.name: a\nCamera.fps: 30.0\nCamera.RGB: 1\nCamera.bf: 40.0\n"
                       "Camera.color_order: RGB\nCamera.ThDepth: 40\nThDepth: 40.0\n"
                       "Camera.focal_x_baseline: 40\nCamera.depth_threshold: 40\n"
                       "Stereo.ThDepth: 40.0\nStereo.b: 0.07\nViewer.CameraSize: 0.08\n"
                       "ORBextractor.nFeatures: 1000\nIMU.T_b_c1: [1, 2]\n"),
            "no error");
}

TEST(ReadCamera, ReadsTheKeysOfOpenVslam) {
  const Camera camera = read_text(
      "Camera.name: \"TUM RGBD 1\"\nCamera.setup: \"RGBD\"\nCamera.model: \"perspective\"\n"
      "Camera.fx: 517.3\nCamera.fy: 516.4\nCamera.cx: 318.6\nCamera.cy: 255.3\nCamera.k1: 0.2624\n"
      "Camera.k2: -0.9531\nCamera.p1: -0.0054\nCamera.p2: 0.0026\nCamera.k3: 1.1633\n"
      "Camera.fps: 30.0\nCamera.cols: 640\nCamera.rows: 480\nCamera.color_order: \"RGB\"\n"
      "depthmap_factor: 5000.0\n");
  EXPECT_EQ(camera.color.width, 640);
  EXPECT_EQ(camera.color.height, 480);
  EXPECT_EQ(camera.depth_scale, 5000);
}

// p1 = 636, a focal length in the wrong place, was accepted without a word.
TEST(ReadCamera, RefusesNumbersInTheWrongPlace) {
  EXPECT_THAT(read_error(std::string(kSettings) + "Camera.p1: 636\n"),
              HasSubstr("c.yaml: camera: no lens has the distortion k1=0 k2=0 p1=636 p2=0 k3=0; "
                        "check the order (k1, k2, p1, p2, k3)"));
  EXPECT_THAT(read_error(std::string(kGood) + "distortion: [0.26, -0.95, 1.16, 0.005, 0.002]\n"),
              HasSubstr("check the order"));
  std::string text = kGood;
  text.replace(text.find("cx: 320"), 7, "cx: 700");
  EXPECT_THAT(read_error(text), HasSubstr("the principal point cx=700 cy=240 is outside"));
}

// A depth camera of 65536 x 65536 took all memory before the first image was read.
TEST(ReadCamera, RefusesImagesOfImpossibleSizes) {
  const std::string depth =
      "depth:\n  width: 65536\n  height: 65536\n  fx: 65536\n  fy: 65536\n  cx: 32768\n"
      "  cy: 32768\n  T_color_depth: [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\n";
  EXPECT_THAT(read_error(kGood + depth), HasSubstr("image size 65536x65536 is too large"));
}

TEST(ReadCamera, SkipsAByteOrderMark) {
  EXPECT_EQ(read_text("\xEF\xBB\xBF" + std::string(kGood)).color.width, 640);
}

TEST(BuiltinCamera, AreTheFilesOfTheConfigFolder) {
  const auto folder = std::filesystem::path(CVO_SLAM_SOURCE_DIR) / "config/cameras";
  EXPECT_THAT(builtin_camera_names(),
              ElementsAre("7scenes", "icl_nuim", "tum_fr1", "tum_fr2", "tum_fr3"));
  for (const auto& name : builtin_camera_names()) {
    const Camera builtin = builtin_camera(name);
    const Camera file = read_camera(folder / (name + ".yaml"));
    EXPECT_EQ(builtin.name, name);
    EXPECT_EQ(file.name, name);
    expect_equal(builtin.color, file.color);
    EXPECT_EQ(builtin.depth.has_value(), name == "7scenes");
  }
  EXPECT_THROW(static_cast<void>(builtin_camera("tum_fr4")), OptionError);
}

TEST(FindCamera, TakesANameOrAFile) {
  EXPECT_EQ(find_camera("icl_nuim").color.fy, -480);
  const TemporaryFolder folder;
  EXPECT_EQ(find_camera(folder.write("c.yaml", kGood).string()).color.fx, 500);
  EXPECT_THAT(input_error("", [] { return find_camera("tum_fr9"); }),
              HasSubstr("the built-in cameras are 7scenes, icl_nuim"));
}

TEST(WriteCamera, SaysWhereItCannotWrite) {
  EXPECT_THROW(write_camera("/nowhere/c.yaml", Camera()), OutputError);
}

TEST(WriteCamera, NoticesAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_THROW(write_camera("/dev/full", Camera()), OutputError);
}

}  // namespace
}  // namespace cvo_slam
