// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/sequence.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/association.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {
namespace {
namespace fs = std::filesystem;
using ::testing::HasSubstr;

SequenceOptions small(std::size_t frames = 5) {
  SequenceOptions options;
  options.frames = frames;
  options.width = 64;
  options.height = 48;
  return options;
}

/// All files of a folder by name.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    files[fs::relative(entry.path(), folder).string()] =
        std::string(std::istreambuf_iterator<char>(stream), {});
  }
  return files;
}

/// The pose that an evaluation takes for an estimate at that stamp.
SE3 reference_pose(const Dataset& data, const Timestamp& stamp) {
  return associate(data.reference(), {{stamp, SE3()}}).front().reference;
}

class Sequence : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / ("cvo_slam_synth_" + std::string(test->name()));
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// The message of the error that writing into `folder` gives.
  template <typename ExpectedError>
  static std::string error_of(const fs::path& folder, const SequenceOptions& options) {
    try {
      write_sequence(folder, options);
    } catch (const ExpectedError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

TEST_F(Sequence, HasTheSameBytesForAnyNumberOfThreadsAndOtherBytesForAnotherSeed) {
  write_sequence(folder_ / "one", small(), 1);
  for (const int threads : {2, 8}) {
    write_sequence(folder_ / "more", small(), threads);
    EXPECT_EQ(contents(folder_ / "one"), contents(folder_ / "more")) << threads;
  }
  SequenceOptions other = small();
  other.seed = 2;
  write_sequence(folder_ / "more", other);
  const auto one = contents(folder_ / "one");
  for (const auto& [name, bytes] : contents(folder_ / "more")) {
    if (name.starts_with("rgb/")) {
      EXPECT_NE(bytes, one.at(name)) << name;
    }
  }
}

TEST_F(Sequence, OpensInTheReaderWithItsOwnCameraPosesAndDepth) {
  const auto summary = write_sequence(folder_, small());
  EXPECT_EQ(summary.frames, 5U);
  const auto data = open_dataset(folder_);
  ASSERT_EQ(data->size(), 5U);
  EXPECT_EQ(data->camera().color.fx, synthetic_camera(64, 48).color.fx);
  // A hundred poses a second in 133 ms, and the five frames, of which two are among them.
  ASSERT_EQ(data->reference().size(), 14U + 5U - 2U);
  const World world = make_world("room");
  const RgbdFrame frame = data->read(3);
  EXPECT_EQ(frame.problem, "");
  EXPECT_EQ(frame.stamp, frame.depth_stamp);
  const StampedPose pose{frame.stamp, reference_pose(*data, frame.stamp)};
  // Poses are written with nine decimals.
  const SE3 expected = world.path.T_world_camera(0.1);
  EXPECT_LT((expected.inverse() * pose.T_world_camera).log().norm(), 3e-9);
  const Rendering rendering = render(world.scene, synthetic_camera(64, 48).color, expected);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      // Half a unit of rounding.
      ASSERT_NEAR(frame.depth.at<std::uint16_t>(y, x) / 5000.0, rendering.depth.at<double>(y, x),
                  0.5 / 5000 + 1e-9);
    }
  }
}

TEST_F(Sequence, AWholeRoundEndsWhereItBegan) {
  SequenceOptions options = small();
  options.frames.reset();
  options.width = options.height = 16;
  const auto summary = write_sequence(folder_, options, 2);
  EXPECT_EQ(summary.frames, 301U);  // 10 s at 30 Hz and the frame that closes the loop
  const auto reference = open_dataset(folder_)->reference();
  const SE3 gap = reference.front().T_world_camera.inverse() * reference.back().T_world_camera;
  EXPECT_LT(gap.log().norm(), 1e-8);
}

TEST_F(Sequence, ANoisyOneHasTheSameBytesForAnyNumberOfThreads) {
  for (const std::string noise : {"kinect", "harsh"}) {
    SequenceOptions options = small(8);
    options.sensor = sensor_preset(noise);
    write_sequence(folder_ / "one", options, 1);
    write_sequence(folder_ / "more", options, 2);
    EXPECT_EQ(contents(folder_ / "one"), contents(folder_ / "more")) << noise;
    options.sensor.seed = 1;
    write_sequence(folder_ / "more", options, 2);
    const auto one = contents(folder_ / "one");
    const auto more = contents(folder_ / "more");
    // Those of the first frame are never dropped.
    EXPECT_NE(one.at("rgb/1000.000000.png"), more.at("rgb/1000.000000.png")) << noise;
    EXPECT_NE(one.at("depth.txt"), more.at("depth.txt")) << noise;
    // The camera's way is that of the world's seed.
    EXPECT_EQ(one.at("camera.yaml"), more.at("camera.yaml"));
  }
}

TEST_F(Sequence, FramesOfANoisyOneArePairedAndHaveTheirExactPoses) {
  SequenceOptions options = small(20);
  options.sensor.timing = {.depth_jitter = 0.011, .drop_color = 0.2, .drop_depth = 0.2};
  write_sequence(folder_, options);
  const auto data = open_dataset(folder_);
  EXPECT_GT(data->unpaired().color + data->unpaired().depth, 0U);
  EXPECT_LT(data->size(), 20U);
  EXPECT_GT(data->size(), 5U);  // about 0.8 * 0.8 of 20
  const World world = make_world("room");
  bool stamps_differ = false;
  for (std::size_t i = 0; i < data->size(); ++i) {
    const RgbdFrame frame = data->read(i);
    EXPECT_EQ(frame.problem, "");
    stamps_differ = stamps_differ || frame.depth_stamp != frame.stamp;
    const SE3 expected = world.path.T_world_camera(frame.stamp.seconds() - 1000);
    EXPECT_LT((expected.inverse() * reference_pose(*data, frame.stamp)).log().norm(), 1e-8);
  }
  EXPECT_TRUE(stamps_differ);
}

TEST_F(Sequence, LapsRepeatAClosedPath) {
  SequenceOptions options = small(1);
  options.frames.reset();
  options.laps = 2;
  options.speed = 50;
  options.sensor.timing.frame_rate = 10;
  const auto summary = write_sequence(folder_, options);
  const double lap = make_world("room", {.speed = 50}).path.duration();
  EXPECT_EQ(summary.frames, static_cast<std::size_t>(std::lround(20 * lap)) + 1);
  options.laps = 0;
  EXPECT_THROW(write_sequence(folder_, options), OptionError);
}

TEST_F(Sequence, SaysHowItWasMade) {
  SequenceOptions options = small(1);
  options.sensor.depth.axial = 0.5;
  options.sensor.exposure.time = 0.01;
  write_sequence(folder_, options);
  const std::string marker = contents(folder_).at("synthetic.yaml");
  EXPECT_THAT(
      marker,
      HasSubstr(
          "cvo_slam synth room <folder> --seed 1 --path own --speed 1 --frames 1 --size 64x48 "
          "--image png --set sensor.depth.axial=0.5 --set "
          "sensor.exposure.time=0.01\n"));
  SensorOptions sensor;
  for (const auto& option : describe(sensor).options()) {
    const auto name = option.key.substr(option.key.rfind('.') + 1);
    EXPECT_THAT(marker, HasSubstr("  " + name + ": ")) << option.key;
  }
}

TEST_F(Sequence, JpegIsOffered) {
  SequenceOptions options = small(1);
  options.image = ImageFormat::kJpeg;
  write_sequence(folder_, options);
  EXPECT_TRUE(fs::exists(folder_ / "rgb" / "1000.000000.jpg"));
  EXPECT_EQ(open_dataset(folder_)->read(0).problem, "");
}

TEST_F(Sequence, ReportsProgressInOrder) {
  std::vector<std::size_t> seen;
  write_sequence(folder_, small(6), 1, [&](std::size_t done, std::size_t total) {
    seen.push_back(done);
    EXPECT_EQ(total, 6U);
  });
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 6U);
}

TEST_F(Sequence, ReplacesAnOlderSequenceButNothingElse) {
  write_sequence(folder_, small(4));
  write_file(folder_ / "notes.txt", "mine");
  write_sequence(folder_, small(2));
  const auto files = contents(folder_);
  EXPECT_EQ(files.count("rgb/1000.100000.png"), 0U);
  EXPECT_EQ(files.at("notes.txt"), "mine");
  EXPECT_EQ(open_dataset(folder_)->size(), 2U);
}

TEST_F(Sequence, LeavesAFolderThatIsNotItsOwnAsItWas) {
  fs::create_directories(folder_ / "rgb");
  write_file(folder_ / "rgb.txt", "mine");
  EXPECT_THAT(error_of<OutputError>(folder_, small()), HasSubstr("is not empty"));
  EXPECT_EQ(contents(folder_), (std::map<std::string, std::string>{{"rgb.txt", "mine"}}));
}

TEST_F(Sequence, BadOptionsAreRefusedBeforeAnythingIsWritten) {
  EXPECT_THAT(error_of<OptionError>(folder_, small(0)), HasSubstr("at least 1"));
  SequenceOptions options = small();
  options.scene = "rom";
  EXPECT_THAT(error_of<OptionError>(folder_, options), HasSubstr("did you mean 'room'"));
  options = small();
  options.width = 3;
  EXPECT_THAT(error_of<OptionError>(folder_, options), HasSubstr("image size 3x48"));
  options = small();
  options.sensor.timing.drop_color = 2;
  EXPECT_THAT(error_of<OptionError>(folder_, options), HasSubstr("sensor.timing.drop_color=2"));
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Sequence, AnUnwritablePlaceIsAClearError) {
  // /proc takes no new folders, not even from root.
  EXPECT_THAT(error_of<OutputError>("/proc/cvo_slam_synth", small()),
              HasSubstr("cannot be prepared"));
  write_file(fs::path(::testing::TempDir()) / "cvo_slam_synth_plain", "x");
  EXPECT_THAT(
      error_of<OutputError>(fs::path(::testing::TempDir()) / "cvo_slam_synth_plain", small()),
      HasSubstr("is not a folder"));
}

}  // namespace
}  // namespace cvo_slam::synthetic
