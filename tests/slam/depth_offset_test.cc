// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The clock between colour and depth of synthetic recordings, whose offset is known.
#include "cvo_slam/slam/depth_offset.h"

#include <memory>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/io/dataset.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

class RecordedFrames final : public FrameSource {
 public:
  explicit RecordedFrames(std::unique_ptr<Dataset> data) : data_(std::move(data)) {}
  std::optional<RgbdFrame> next() override {
    if (next_ >= data_->size()) return std::nullopt;
    return data_->read(next_++);
  }

 private:
  std::unique_ptr<Dataset> data_;
  std::size_t next_ = 0;
};

class DepthOffsetOfARecording : public testing::Test {
 protected:
  void record(double offset, synthetic::PathStyle path = synthetic::PathStyle::kHandheld) {
    synthetic::SequenceOptions options;
    options.path = path;
    options.frames = 130;
    options.width = 320;
    options.height = 240;
    options.image = synthetic::ImageFormat::kJpeg;
    options.speed = 1.5;
    options.sensor.timing.depth_jitter = 0.01;
    options.sensor.timing.depth_offset = offset;
    synthetic::write_sequence(folder_.path() / "recording", options, 2);
  }

  [[nodiscard]] DepthOffset measured() const {
    const auto open = [&](double depth_offset) {
      DatasetOptions options;
      options.depth_offset = depth_offset;
      return std::make_unique<RecordedFrames>(open_dataset(folder_.path() / "recording", options));
    };
    DepthOffsetOptions options;
    options.min_frames = 100;
    options.settled_time = 2;
    return calibrate_depth_offset(open, synthetic::synthetic_camera(320, 240), {}, options);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(DepthOffsetOfARecording, IsFoundWithinItsUncertainty) {
  for (const double offset : {-0.02, 0.0, 0.012}) {
    record(offset);
    const DepthOffset found = measured();
    ASSERT_TRUE(found.is_measured) << found.reason;
    EXPECT_NEAR(found.seconds, offset, 0.003) << found.reason;
    EXPECT_GT(found.uncertainty, 0);
    EXPECT_LT(found.uncertainty, 0.002);
  }
}

TEST_F(DepthOffsetOfARecording, IsZeroWhereTheCameraDoesNotMove) {
  record(-0.02, synthetic::PathStyle::kStill);
  const DepthOffset found = measured();
  EXPECT_FALSE(found.is_measured);
  EXPECT_EQ(found.seconds, 0);
  EXPECT_THAT(found.reason, testing::HasSubstr("the recording does not tell"));
}

TEST(DepthOffset, IsZeroOfARecordingWithoutFrames) {
  class NoFrames final : public FrameSource {
    std::optional<RgbdFrame> next() override { return std::nullopt; }
  };
  const DepthOffset found = calibrate_depth_offset(
      [](double) { return std::make_unique<NoFrames>(); }, synthetic::synthetic_camera(160, 120));
  EXPECT_FALSE(found.is_measured);
  EXPECT_EQ(found.frames, 0U);
}

}  // namespace
}  // namespace cvo_slam
