// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// `cvo_slam render` from outside, without a display: what it draws, its exit codes, its errors.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/io/g2o.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/io/ply.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/tests/apps/run_program.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

/// Ten keyframes on a half circle over a floor, z up, with a loop.
Map small_map() {
  Map map;
  for (int i = 0; i < 10; ++i) {
    const SE3 pose(so3_exp({0, 0, 0.3 * i}) * Matrix3{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                   {std::cos(0.3 * i), std::sin(0.3 * i), 1});
    map.keyframes.push_back({Timestamp::from_seconds(i), pose});
    map.graph.add_node({i, pose});
    if (i == 0) continue;
    const SE3& before = map.graph.nodes()[static_cast<std::size_t>(i) - 1].T_world_node;
    map.graph.add_edge({i - 1, i, before.inverse() * pose});
  }
  map.graph.add_edge({0, 9, SE3(), Matrix6::Identity(), EdgeKind::kLoop, true});
  for (int i = 0; i < 10'000; ++i) {
    map.points.push_back({{0.03F * static_cast<float>(i % 100) - 1.5F,
                           0.03F * static_cast<float>(i) / 100 - 1.5F, 0},
                          {0, 0, 1},
                          {90, 110, 130}});
  }
  return map;
}

class RenderCommand : public testing::Test {
 protected:
  RenderCommand() {
    unsetenv("DISPLAY");
    write_map(map_, small_map());
    write_tum(map_ / "trajectory.txt", {small_map().keyframes, {}});
  }

  static ProgramResult render(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"--size", "320x240"});
    return run_program(arguments);
  }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }

  /// Expects a picture of that size with something on it.
  static void expect_picture(const std::string& file) {
    const cv::Mat image = cv::imread(file);
    ASSERT_EQ(image.size(), cv::Size(320, 240)) << file;
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(image, mean, deviation);
    EXPECT_GT(deviation[0], 3) << file;
    EXPECT_GT(mean[0], 50) << file;  // not a black image
  }

  TemporaryFolder folder_;
  std::filesystem::path map_ = folder_.path() / "map";
};

TEST_F(RenderCommand, DrawsAMapWithEveryViewAndBackend) {
  for (const std::string view : {"top", "front", "side", "iso", "turntable", "follow"}) {
    const auto result = render({map_, "-o", path(view + ".png"), "--view", view});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    expect_picture(path(view + ".png"));
  }
  for (const std::string backend : {"osmesa", "splat"}) {
    const auto result = render({map_, "-o", path(backend + ".jpg"), "--backend", backend});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("10000 points, 10 keyframes, drawn by " + backend));
    expect_picture(path(backend + ".jpg"));
  }
}

TEST_F(RenderCommand, DrawsTrajectoriesGraphsAndPoints) {
  const std::string trajectory = map_ / "trajectory.txt";
  const std::vector<std::vector<std::string>> inputs = {
      {trajectory},
      {trajectory, map_ / "keyframes.txt"},
      {map_ / "graph.g2o"},
      {map_ / "map.ply"},
      {trajectory, map_ / "map.ply"},
      {trajectory, "--reference", trajectory, "--color", "error"},
      {trajectory, "--color", "plain", "--up", "z", "--title", "half a circle"}};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    std::vector<std::string> arguments = inputs[i];
    arguments.insert(arguments.end(), {"-o", path("out.png")});
    const auto result = render(arguments);
    EXPECT_EQ(result.exit_code, 0) << i << ": " << result.errors;
    expect_picture(path("out.png"));
    std::filesystem::remove(path("out.png"));
  }
}

TEST_F(RenderCommand, UpIsWhatTheUserSaysWhateverTheReferenceSays) {
  const std::string trajectory = map_ / "trajectory.txt";
  for (const std::string up : {"z", "-z", "auto"}) {
    const auto result =
        render({trajectory, "--reference", trajectory, "--up", up, "-o", path(up + ".png")});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
  }
  EXPECT_NE(read_text(path("z.png")), read_text(path("-z.png")));
  EXPECT_EQ(read_text(path("z.png")), read_text(path("auto.png")));
}

TEST_F(RenderCommand, ATurntableIsNumberedPicturesAndAVideoAFile) {
  const auto result =
      render({map_, "-o", path("turn.png"), "--turntable", "3", "--video", path("turn.avi")});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  for (const char* name : {"turn_0000.png", "turn_0001.png", "turn_0002.png"}) {
    expect_picture(path(name));
  }
  EXPECT_FALSE(std::filesystem::exists(path("turn_0003.png")));
  EXPECT_NE(read_text(path("turn_0000.png")), read_text(path("turn_0001.png")));
  EXPECT_THAT(read_text(path("turn.avi")), testing::StartsWith("RIFF"));
}

TEST_F(RenderCommand, OnePoseAndPosesThatAreNotFiniteAreDrawnOrNoted) {
  const auto one = folder_.write("one.txt", "0 1 2 3 0 0 0 1\n");
  EXPECT_EQ(render({one, "-o", path("one.png")}).exit_code, 0);
  expect_picture(path("one.png"));
  const auto points =
      folder_.write("nan.ply",
                    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                    "property float z\nend_header\n0 0 0\nnan 0 0\n1 1 1\n");
  const auto result = render({points, "-o", path("nan.png")});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors, "note: 1 point left out: not finite, or beyond 10000 km\n");
  expect_picture(path("nan.png"));
}

/// Two rows of 50 points, 1/64 m apart, a metre long, at an offset; exact in binary.
std::string two_rows(const std::string& type, double x, double y) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex 100\nproperty {0} x\nproperty {0} y\n"
      "property {0} z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "end_header\n",
      type);
  for (int i = 0; i < 100; ++i) {
    const int row = i / 50;
    const double along = static_cast<double>(i % 50) / 64;
    const double aside = static_cast<double>(row) / 64;
    text += fmt::format("{:.6f} {:.6f} 0 200 0 0\n", x + aside, y + along);
  }
  return text;
}

// The two rows became lines half a metre apart, the distance of floats near 5000 km.
TEST_F(RenderCommand, PointsInUtmCoordinatesAreDrawnAsThoseNearZero) {
  const auto near = folder_.write("near.ply", two_rows("float", 0, 0));
  const auto far = folder_.write("far.ply", two_rows("double", 400000, 5000000));
  for (const std::string view : {"top", "iso"}) {
    const auto result = render({near, "-o", path("near.png"), "--view", view});
    EXPECT_EQ(result.errors, "");
    EXPECT_EQ(render({far, "-o", path("far.png"), "--view", view}).errors,
              "note: far from the origin: axes and numbers of the picture begin at (400000, "
              "5000000, 0) m\n");
    EXPECT_EQ(read_text(path("near.png")), read_text(path("far.png"))) << view;
  }
}

/// Rows of a trajectory in TUM format along a curve at an offset; exact in binary.
std::string rows_of_curve(double x, double y) {
  std::string text;
  for (int i = 0; i < 32; ++i) {
    text += fmt::format("{}.5 {:.6f} {:.6f} 1 0 0 0 1\n", i, x + i / 8.0, y + i * i / 128.0);
  }
  return text;
}

TEST_F(RenderCommand, TrajectoriesInUtmCoordinatesAreDrawnAsThoseNearZero) {
  const auto near = folder_.write("near/path.txt", rows_of_curve(0, 0));
  const auto far = folder_.write("far/path.txt", rows_of_curve(400000, 5000000));
  const auto near_points = folder_.write("near.ply", two_rows("float", 0, 0));
  const auto far_points = folder_.write("far.ply", two_rows("double", 400000, 5000000));
  for (const std::string view : {"top", "follow"}) {
    EXPECT_EQ(render({near, near_points, "-o", path("near.png"), "--view", view}).exit_code, 0);
    EXPECT_EQ(render({far, far_points, "-o", path("far.png"), "--view", view}).exit_code, 0);
    EXPECT_EQ(read_text(path("near.png")), read_text(path("far.png"))) << view;
  }
  // A reference near zero is fitted to the path wherever that is.
  EXPECT_EQ(render({near, "--reference", near, "-o", path("near.png")}).exit_code, 0);
  EXPECT_EQ(render({far, "--reference", near, "-o", path("far.png")}).exit_code, 0);
  expect_picture(path("far.png"));
}

TEST_F(RenderCommand, FilesAreToldApartByAnyCaseOfTheirNameOrByTheirContent) {
  const std::vector<std::pair<std::string, std::string>> files = {{"map.ply", "A.PLY"},
                                                                  {"map.ply", "points.txt"},
                                                                  {"graph.g2o", "B.G2O"},
                                                                  {"graph.g2o", "graph"},
                                                                  {"trajectory.txt", "path.dat"}};
  for (const auto& [from, to] : files) {
    std::filesystem::copy(map_ / from, folder_.path() / to);
    EXPECT_EQ(render({map_ / from, "-o", path("a.png")}).errors, "");
    const auto result = render({path(to), "-o", path("b.png")});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    if (from != "trajectory.txt") {  // whose name is in the legend
      EXPECT_EQ(read_text(path("a.png")), read_text(path("b.png"))) << to;
    }
  }
}

TEST_F(RenderCommand, WhatIsNotUnderstoodIsNoted) {
  const auto points = folder_.write("grey.ply",
                                    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                                    "property float y\nproperty float z\nproperty float f_dc_0\n"
                                    "end_header\n0 0 0 1\n1 inf 0 1\n");
  EXPECT_EQ(render({points, "-o", path("a.png")}).errors,
            "note: grey.ply: no red, green and blue among the properties (f_dc_0); the points are "
            "grey\nnote: 1 point left out: not finite, or beyond 10000 km\n");
  const auto graph = folder_.write("a.g2o", read_text(map_ / "graph.g2o") + "PARAMS_X 0\n");
  EXPECT_EQ(render({graph, "-o", path("a.png")}).errors,
            "note: a.g2o: 1 line PARAMS_X skipped, from line 21 on: parameters are not read\n");
  const auto path_file = folder_.write("a.txt", "1 0 0 0 0 0 0 1\n0 1 1 1 0 0 0 1\n");
  EXPECT_EQ(render({path_file, "-o", path("a.png")}).errors,
            "note: a.txt: stamps out of order; sorted\n");
}

TEST_F(RenderCommand, BadInputIsAClearLine) {
  const std::string out = path("out.png");
  const auto empty = folder_.write("empty.txt", "# nothing\n");
  const auto wrong = folder_.write("wrong.txt", "0 one 0 0 0 0 0 1\n");
  std::filesystem::create_directory(folder_.path() / "void");
  expect_error(render({empty, "-o", out}), 2, "nothing to draw: no point and no pose");
  expect_error(render({wrong, "-o", out}), 2, "wrong.txt:1");
  expect_error(render({path("void"), "-o", out}), 2, "holds no map");
  expect_error(render({path("none.txt"), "-o", out}), 2, "none.txt: cannot be opened");
  expect_error(render({map_, "-o", path("no/out.png")}), 1, "no/out.png: cannot be written");
  expect_error(render({map_}), 2, "say where to write the picture");
  expect_error(render({map_, "-o", out, "--color", "error"}), 2, "--reference");
  expect_error(render({map_ / "map.ply", "-o", out, "--view", "follow"}), 2, "needs a trajectory");
  expect_error(render({map_, "--turntable", "2", "--video", path("a.mp4")}), 2, ".avi");
  expect_error(run_program({"render", map_, "-o", out, "--size", "9x9"}), 2, "64 to 4096");
  expect_error(run_program({"render", map_, "-o", out, "--size", "big"}), 2, "<width>x<height>");
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace cvo_slam
