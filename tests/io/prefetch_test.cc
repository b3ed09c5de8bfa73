// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/io/dataset.h"

namespace cvo_slam {
namespace {

/// Ten frames without images; reading frame 7 fails.
class NumberedFrames : public Dataset {
 public:
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] const std::string& kind() const override { return name_; }
  [[nodiscard]] const Camera& camera() const override { return camera_; }
  [[nodiscard]] const std::string& camera_origin() const override { return name_; }
  [[nodiscard]] std::size_t size() const override { return 10; }
  [[nodiscard]] RgbdFrame read(std::size_t index) const override {
    if (index == 7) throw std::runtime_error("seven");
    RgbdFrame frame;
    frame.index = index;
    return frame;
  }
  [[nodiscard]] Timestamp stamp(std::size_t /*index*/) const override { return {}; }
  [[nodiscard]] Timestamp depth_stamp(std::size_t /*index*/) const override { return {}; }
  [[nodiscard]] UnpairedImages unpaired() const override { return {}; }
  [[nodiscard]] const std::vector<StampedPose>& reference() const override { return reference_; }
  [[nodiscard]] const std::vector<std::string>& notes() const override { return notes_; }

 private:
  std::string name_ = "numbers";
  Camera camera_;
  std::vector<StampedPose> reference_;
  std::vector<std::string> notes_;
};

/// Indices of the frames that are left, at most ten: a prefetcher that is never done must not hang
/// the test.
std::vector<std::size_t> rest_of(FramePrefetcher& frames) {
  std::vector<std::size_t> indices;
  while (indices.size() < 10) {
    const auto frame = frames.next();
    if (!frame) break;
    indices.push_back(frame->index);
  }
  return indices;
}

TEST(FramePrefetcher, GivesEveryFrameOfTheRangeInOrder) {
  const NumberedFrames data;
  for (const std::size_t ahead : {1U, 3U, 100U}) {
    FramePrefetcher frames(data, 2, 6, 1, ahead);
    EXPECT_EQ(rest_of(frames), std::vector<std::size_t>({2, 3, 4, 5}));
  }
}

TEST(FramePrefetcher, LeavesOutFramesBetweenSteps) {
  const NumberedFrames data;
  FramePrefetcher frames(data, 0, 7, 3);
  EXPECT_EQ(rest_of(frames), std::vector<std::size_t>({0, 3, 6}));
}

TEST(FramePrefetcher, IsDoneAtOnceIfTheRangeIsEmpty) {
  const NumberedFrames data;
  EXPECT_FALSE(FramePrefetcher(data, 3, 3).next());
}

TEST(FramePrefetcher, ThrowsWhatReadingThrows) {
  const NumberedFrames data;
  FramePrefetcher frames(data, 6, 10);
  EXPECT_EQ(frames.next()->index, 6U);
  EXPECT_THROW(static_cast<void>(frames.next()), std::runtime_error);
  EXPECT_EQ(frames.next()->index, 8U);
}

TEST(FramePrefetcher, MayBeLeftBeforeItsEnd) {
  const NumberedFrames data;
  FramePrefetcher frames(data, 0, 6);
  EXPECT_EQ(frames.next()->index, 0U);
}

}  // namespace
}  // namespace cvo_slam
