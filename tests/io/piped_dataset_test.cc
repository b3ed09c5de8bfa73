// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <atomic>
#include <functional>
#include <future>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/followed_dataset.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

class PipedDatasetTest : public testing::Test {
 protected:
  PipedDatasetTest() {
    EXPECT_EQ(pipe(ends_.data()), 0);
    sequence_.write_tum();
  }
  ~PipedDatasetTest() override {
    close_writer();
    close(ends_[0]);
  }
  PipedDatasetTest(const PipedDatasetTest&) = delete;
  PipedDatasetTest& operator=(const PipedDatasetTest&) = delete;

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
  std::string error_of_line(const std::string& text) {
    write(text);
    close_writer();
    PipedDataset frames = open();
    try {
      while (frames.next()) {
      }
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
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

TEST_F(PipedDatasetTest, LinesThatAreNoneAreNamed) {
  EXPECT_THAT(error_of_line("1.0 a.png\n"),
              testing::AllOf(HasSubstr(":1"), HasSubstr("stamp file")));
}

TEST_F(PipedDatasetTest, StampsMustAscend) {
  EXPECT_THAT(error_of_line(line(1) + line(0)),
              testing::AllOf(HasSubstr(":2"), HasSubstr("above")));
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
