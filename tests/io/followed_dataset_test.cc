// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/followed_dataset.h"

#include <atomic>
#include <chrono>
#include <fstream>
#include <future>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

void append(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::app) << text;
}

class FollowedDatasetTest : public testing::Test {
 protected:
  /// Writes the images of a frame and its lines in the lists, as a recorder does.
  void record(int number) const {
    const auto name = fmt::format("{}.png", number);
    sequence_.write_color("rgb/" + name);
    sequence_.write_depth("depth/" + name);
    append(sequence_.path() / "rgb.txt", fmt::format("{}.10 rgb/{}\n", number, name));
    append(sequence_.path() / "depth.txt", fmt::format("{}.11 depth/{}\n", number, name));
  }
  [[nodiscard]] FollowedDataset follow(double end_after = 1) const {
    return FollowedDataset(sequence_.path(), {.camera = tiny_camera()}, {.end_after = end_after});
  }
  TinySequence sequence_;
};

TEST_F(FollowedDatasetTest, ReturnsFramesWhileTheyAreWritten) {
  record(0);
  auto frames = follow();
  // The second frame is written when the first one is asked for, and so on: the last one comes when
  // nothing has changed for a while.
  for (int i = 0; i < 4; ++i) {
    const auto recorder = std::async(std::launch::async, [&] {
      if (i < 3) record(i + 1);
    });
    const auto frame = frames.next();
    ASSERT_TRUE(frame) << i;
    EXPECT_EQ(frame->problem, "");
    EXPECT_EQ(frame->index, static_cast<std::size_t>(i));
    EXPECT_EQ(frame->stamp.to_string(), fmt::format("{}.10", i));
    EXPECT_EQ(frames.size(), static_cast<std::size_t>(i) + 1);
  }
  EXPECT_FALSE(frames.next());
  EXPECT_EQ(frames.kind(), "TUM RGB-D");
  EXPECT_EQ(frames.camera().name, "tiny");
  EXPECT_EQ(frames.camera_origin(), "given by the caller");
  EXPECT_EQ(frames.depth_stamp(2).to_string(), "2.11");
  EXPECT_EQ(frames.read(2).stamp, frames.stamp(2));
  EXPECT_EQ(frames.read(2).color.rows, 6);
}

TEST_F(FollowedDatasetTest, FollowsNumberedFilesToo) {
  const auto record_numbered = [&](int number) {
    sequence_.write_color(fmt::format("frame-{:06}.color.png", number));
    sequence_.write_depth(fmt::format("frame-{:06}.depth.png", number));
  };
  record_numbered(0);
  auto frames = follow();
  const auto recorder = std::async(std::launch::async, [&] { record_numbered(1); });
  ASSERT_TRUE(frames.next());
  ASSERT_TRUE(frames.next());
  EXPECT_FALSE(frames.next());
}

TEST_F(FollowedDatasetTest, WaitsForTheFirstFrame) {
  const auto recorder = std::async(std::launch::async, [&] { record(0); });
  auto frames = follow(2);
  EXPECT_EQ(frames.size(), 0U);
}

TEST_F(FollowedDatasetTest, WithoutAnyFrameItSaysWhatIsMissing) {
  EXPECT_THAT(input_error(sequence_.path(), [&] { return follow(0.05).size(); }),
              HasSubstr("is no known data set"));
  EXPECT_THROW(std::ignore = follow(0).size(), OptionError);
}

TEST_F(FollowedDatasetTest, StopsWhenItIsTold) {
  record(0);
  std::atomic<bool> stop = false;
  FollowedDataset frames(sequence_.path(), {.camera = tiny_camera()},
                         {.end_after = 1000, .stop = [&] { return stop.load(); }});
  const auto user = std::async(std::launch::async, [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop = true;
  });
  EXPECT_FALSE(frames.next());
}

// A recorder that writes the lists first.
TEST_F(FollowedDatasetTest, TriesImagesAgainThatAreNotWholeYet) {
  record(0);
  record(1);
  const auto image = sequence_.path() / "rgb/0.png";
  std::filesystem::rename(image, sequence_.path() / "whole.png");
  std::ofstream(image) << "\x89PNG";
  auto frames = follow();
  const auto recorder = std::async(std::launch::async, [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    std::filesystem::rename(sequence_.path() / "whole.png", image);
  });
  EXPECT_EQ(frames.next()->problem, "");
}

TEST_F(FollowedDatasetTest, ImagesThatNeverBecomeWholeAreAProblemOfTheirFrame) {
  record(0);
  record(1);
  std::ofstream(sequence_.path() / "rgb/0.png") << "\x89PNG";
  auto frames = follow();
  EXPECT_THAT(frames.next()->problem, HasSubstr("0.png"));
  EXPECT_EQ(frames.next()->problem, "");
}

TEST_F(FollowedDatasetTest, AListThatEndsWithinALineIsReadAgain) {
  record(0);
  record(1);
  auto frames = follow(1);
  ASSERT_TRUE(frames.next());
  append(sequence_.path() / "rgb.txt", "2.1");
  const auto recorder = std::async(std::launch::async, [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    append(sequence_.path() / "rgb.txt", "0 rgb/2.png\n");
    append(sequence_.path() / "depth.txt", "2.11 depth/2.png\n");
    sequence_.write_color("rgb/2.png");
    sequence_.write_depth("depth/2.png");
  });
  ASSERT_TRUE(frames.next());
  EXPECT_EQ(frames.next()->problem, "");
  EXPECT_FALSE(frames.next());
  EXPECT_THAT(frames.notes(), SizeIs(1));  // there is no ground truth
}

// A depth image that is nearer comes after the frame that would have taken the other one.
TEST_F(FollowedDatasetTest, PairsAreThoseOfTheFinishedRecording) {
  for (const char* name : {"0", "1", "2", "3"}) {
    sequence_.write_color(fmt::format("rgb/{}.png", name));
    sequence_.write_depth(fmt::format("depth/{}.png", name));
  }
  sequence_.write("rgb.txt", "1.000 rgb/0.png\n1.035 rgb/1.png\n");
  sequence_.write("depth.txt", "0.981 depth/0.png\n1.018 depth/1.png\n");
  auto frames = follow();
  const auto recorder = std::async(std::launch::async, [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    append(sequence_.path() / "depth.txt", "1.045 depth/2.png\n2.000 depth/3.png\n");
    append(sequence_.path() / "rgb.txt", "2.000 rgb/2.png\n");
  });
  const auto first = frames.next();
  ASSERT_TRUE(first);
  recorder.wait();
  EXPECT_EQ(first->depth_stamp, sequence_.open()->depth_stamp(0));
  EXPECT_EQ(frames.depth_stamp(0), first->depth_stamp);
}

TEST_F(FollowedDatasetTest, ACameraThatIsNotKnownIsSaidWhileTheRecordingGoesOn) {
  record(0);
  record(1);
  std::atomic<bool> stop = false;
  const auto recorder = std::async(std::launch::async, [&] {
    for (int i = 2; i < 100 && !stop; ++i) {
      record(i);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  });
  EXPECT_THAT(
      input_error(sequence_.path(), [&] { return FollowedDataset(sequence_.path()).size(); }),
      HasSubstr("--camera"));
  stop = true;
}

TEST_F(FollowedDatasetTest, TheLayoutOfTheFirstFrameStays) {
  for (int i = 0; i < 8; ++i) {
    sequence_.write_color(fmt::format("rgb/{}.png", i));
    sequence_.write_depth(fmt::format("depth/{}.png", i));
  }
  auto frames = follow();
  ASSERT_TRUE(frames.next());
  for (int i = 0; i < 8; ++i) {
    append(sequence_.path() / "rgb.txt", fmt::format("{}.5 rgb/{}.png\n", 1000 + i, i));
    append(sequence_.path() / "depth.txt", fmt::format("{}.5 depth/{}.png\n", 1000 + i, i));
  }
  std::size_t count = 1;
  while (frames.next()) ++count;
  EXPECT_EQ(count, 8U);
  EXPECT_EQ(frames.kind(), "image folders");
  EXPECT_THAT(frames.notes().back(), HasSubstr("it is followed as that"));
}

TEST_F(FollowedDatasetTest, FramesOutOfOrderAreLeftOutAndSaid) {
  record(0);
  record(5);
  auto frames = follow();
  ASSERT_TRUE(frames.next());
  ASSERT_TRUE(frames.next());
  record(3);
  record(6);
  EXPECT_EQ(frames.next()->stamp.to_string(), "6.10");
  EXPECT_EQ(frames.stamp(1).to_string(), "5.10");
  EXPECT_EQ(frames.read(1).stamp.to_string(), "5.10");
  EXPECT_FALSE(frames.next());
  EXPECT_THAT(frames.notes().back(), HasSubstr("1 frames appeared after frames with later stamps"));
}

}  // namespace
}  // namespace cvo_slam
