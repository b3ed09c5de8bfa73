// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <atomic>
#include <functional>
#include <future>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/followed_dataset.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class PipedDatasetTest : public testing::Test {
 public:
  PipedDatasetTest(PipedDatasetTest&&) = delete;
  PipedDatasetTest& operator=(PipedDatasetTest&&) = delete;

 protected:
  PipedDatasetTest() {
    EXPECT_EQ(pipe(ends_.data()), 0);
    sequence_.write_tum();
  }
  ~PipedDatasetTest() override {
    close_writer();
    close(ends_[0]);
  }

  void write(const std::string& text) const {
    EXPECT_EQ(::write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void close_writer() {
    if (ends_[1] >= 0) close(std::exchange(ends_[1], -1));
  }
  /// The line of one of the two frames.
  [[nodiscard]] std::string line(int i) const {
    return fmt::format("0.{}00 {} 0.{}05 {}\n", i, file("rgb", i), i, file("depth", i));
  }
  [[nodiscard]] std::string file(const char* folder, int i) const {
    return (sequence_.path() / folder / fmt::format("{}.png", i)).string();
  }
  [[nodiscard]] PipedDataset open(std::function<bool()> stop = {}) const {
    return PipedDataset(ends_[0], {.camera = tiny_camera()}, std::move(stop));
  }
  /// What is said of lines before a good one.
  std::vector<std::string> notes_of(const std::string& text) {
    write(text + line(1));
    close_writer();
    PipedDataset frames = open();
    EXPECT_TRUE(frames.next());
    while (frames.next()) {
    }
    return frames.notes();
  }

  TinySequence sequence_;
  std::array<int, 2> ends_ = {-1, -1};
};

TEST_F(PipedDatasetTest, ReturnsFramesWhenTheirLinesCome) {
  PipedDataset frames = open();
  write("# a recorder's first words\n\n" + line(0).substr(0, 10));
  const auto recorder = std::async(std::launch::async, [&] { write(line(0).substr(10)); });
  const auto first = frames.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->problem, "");
  EXPECT_EQ(first->stamp.to_string(), "0.000");
  EXPECT_EQ(first->depth_stamp.to_string(), "0.005");
  EXPECT_EQ(frames.size(), 1U);
  const std::string last = line(1);
  write(last.substr(0, last.size() - 1));  // without an end of line
  close_writer();
  const auto second = frames.next();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->index, 1U);
  EXPECT_FALSE(frames.next());
  EXPECT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames.read(0).color.cols, 8);
  EXPECT_EQ(frames.stamp(1), second->stamp);
  EXPECT_EQ(frames.camera().name, "tiny");
}

TEST_F(PipedDatasetTest, TheDepthImageMayComeFirst) {
  write(fmt::format("0.005 {} 0.000 {}\n", file("depth", 0), file("rgb", 0)));
  PipedDataset frames = open();
  const auto frame = frames.next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->problem, "");
  EXPECT_EQ(frame->stamp.to_string(), "0.000");
  EXPECT_EQ(frame->depth.type(), CV_16UC1);
}

TEST_F(PipedDatasetTest, AnImageThatIsMissingIsALostFrame) {
  write("1.0 none.png 1.0 none_depth.png\n");
  PipedDataset frames = open();
  const auto frame = frames.next();
  ASSERT_TRUE(frame);
  EXPECT_THAT(frame->problem, HasSubstr("none.png"));
}

// A recorder that dies within a line takes nothing else with it.
TEST_F(PipedDatasetTest, LinesThatAreNoneAreLeftOutWithANote) {
  EXPECT_THAT(notes_of("1.0 a.png\nx a.png y b.png\n"),
              ElementsAre(AllOf(HasSubstr(":1"), HasSubstr("stamp file")), HasSubstr(":2")));
}

TEST_F(PipedDatasetTest, FramesThatComeTooLateAreLeftOutWithANote) {
  EXPECT_THAT(notes_of(line(1) + line(0)),
              ElementsAre(AllOf(HasSubstr(":2"), HasSubstr("above")), HasSubstr(":3")));
}

// The first depth image is not there: nothing says yet which of the two is of depth.
TEST_F(PipedDatasetTest, TheFirstPairMayBeBroken) {
  write(fmt::format("0.005 none.png 0.000 {}\n", file("rgb", 0)));
  write(fmt::format("0.105 {} 0.100 {}\n", file("depth", 1), file("rgb", 1)));
  PipedDataset frames = open();
  EXPECT_NE(frames.next()->problem, "");
  EXPECT_EQ(frames.next()->problem, "");
}

TEST_F(PipedDatasetTest, StopsWhenItIsTold) {
  std::atomic<bool> stop = false;
  PipedDataset frames = open([&] { return stop.load(); });
  const auto user = std::async(std::launch::async, [&] { stop = true; });
  EXPECT_FALSE(frames.next());
}

TEST_F(PipedDatasetTest, NeedsItsCamera) {
  EXPECT_THROW(PipedDataset(ends_[0], {}), OptionError);
  EXPECT_THROW(PipedDataset(ends_[0], {.camera = tiny_camera(), .associations = "a.txt"}),
               OptionError);
}

}  // namespace
}  // namespace cvo_slam
