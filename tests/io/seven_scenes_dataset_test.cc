// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/depth_registration.h"
#include "cvo_slam/tests/io/tiny_sequence.h"
#include "cvo_slam/tests/test_data.h"

namespace cvo_slam {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr const char* kIdentity = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";

void write_frame(const TinySequence& sequence, const std::string& number,
                 const std::string& pose = kIdentity) {
  sequence.write_color("frame-" + number + ".color.png");
  sequence.write_depth("frame-" + number + ".depth.png", 1000);
  sequence.write("frame-" + number + ".pose.txt", pose);
}

TEST(SevenScenesDataset, StampsFramesAt30Hz) {
  const TinySequence sequence;
  write_frame(sequence, "000000");
  write_frame(sequence, "000003");  // a gap in the numbers is a gap in time
  const auto data = sequence.open();
  EXPECT_EQ(data->kind(), "7-Scenes");
  ASSERT_EQ(data->size(), 2);
  EXPECT_EQ(data->stamp(0).to_string(), "0.000000");
  EXPECT_EQ(data->stamp(1).to_string(), "0.100000");
  EXPECT_EQ(data->read(1).stamp, data->reference()[1].stamp);
  EXPECT_EQ(data->read(1).problem, "");
}

TEST(SevenScenesDataset, ItsLayoutDoesNotTellTheCamera) {
  const TinySequence sequence;
  write_frame(sequence, "000000");
  EXPECT_THAT(input_error(sequence.path(), [&] { return open_dataset(sequence.path()); }),
              HasSubstr("the camera of this sequence is not known"));
}

TEST(SevenScenesDataset, Reads65535AsNone) {
  const TinySequence sequence;
  write_frame(sequence, "000000");
  cv::Mat depth(6, 8, CV_16UC1, cv::Scalar(1000));
  depth.at<std::uint16_t>(2, 3) = 65535;
  sequence.write_image("frame-000000.depth.png", depth);
  const RgbdFrame frame = sequence.open()->read(0);
  EXPECT_EQ(frame.depth.at<std::uint16_t>(2, 3), 0);
  EXPECT_EQ(frame.depth.at<std::uint16_t>(2, 4), 1000);
  depth.setTo(65535);
  sequence.write_image("frame-000000.depth.png", depth);
  EXPECT_THAT(sequence.open()->read(0).problem, HasSubstr("no valid pixel"));
}

TEST(SevenScenesDataset, MovesPosesToTheColourCamera) {
  const TinySequence sequence;
  write_frame(sequence, "000000", "1 0 0 5\n0 1 0 6\n0 0 1 7\n0 0 0 1\n");
  Camera camera = tiny_camera();
  // The origin of the depth camera is 0.1 m to the left of the colour camera.
  camera.depth = DepthCamera{camera.color, SE3(Matrix3::Identity(), Vector3(-0.1, 0, 0))};
  const auto data = sequence.open(camera);
  EXPECT_LT((data->reference()[0].T_world_camera.translation() - Vector3(5.1, 6, 7)).norm(), 1e-12);
}

TEST(SevenScenesDataset, SkipsPosesThatAreNone) {
  const TinySequence sequence;
  write_frame(sequence, "000000");
  write_frame(sequence, "000001", "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0");
  write_frame(sequence, "000002", "nan 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  write_frame(sequence, "000003", "1 0 0 0\n");
  write_frame(sequence, "000004");
  std::filesystem::remove(sequence.path() / "frame-000004.pose.txt");
  const auto data = sequence.open();
  EXPECT_EQ(data->size(), 5);
  EXPECT_EQ(data->reference().size(), 1);
  EXPECT_THAT(data->notes(), Contains(HasSubstr("4 frames have no usable pose file")));
}

TEST(SevenScenesDataset, LeavesOutFramesWithoutDepth) {
  const TinySequence sequence;
  write_frame(sequence, "000000");
  sequence.write_color("frame-000001.color.png");
  EXPECT_EQ(sequence.open()->size(), 1);
  EXPECT_EQ(sequence.open()->unpaired().color, 1);
  std::filesystem::remove(sequence.path() / "frame-000000.depth.png");
  EXPECT_THROW(static_cast<void>(sequence.open()), InputError);
}

TEST(SevenScenesDataset, ReadsTheRealPosesAsRotations) {
  CVO_SLAM_REQUIRE_DATA("7scenes/seq-01");
  const auto data = open_dataset(test_data() / "7scenes/seq-01");
  ASSERT_EQ(data->size(), 1000);
  ASSERT_EQ(data->reference().size(), 1000);
  for (const auto& pose : data->reference()) {
    const Matrix3& R = pose.T_world_camera.rotation();
    EXPECT_LT((R * R.transpose() - Matrix3::Identity()).norm(), 1e-14);
  }
}

/// Returns the mean distance from the near side of depth steps to the nearest colour edge, each at
/// most 10 [px].
double edge_distance(const cv::Mat& color, const cv::Mat& depth) {
  constexpr int kReach = 3;        // px over which a depth step is looked for
  constexpr int kStep = 150;       // mm
  constexpr int kFarthest = 3000;  // mm; beyond this the sensor's own steps reach kStep
  cv::Mat grey;
  cv::Mat edges;
  cv::Mat distance;
  cv::cvtColor(color, grey, cv::COLOR_BGR2GRAY);
  cv::GaussianBlur(grey, grey, {5, 5}, 0);
  cv::Canny(grey, edges, 30, 60);
  cv::distanceTransform(255 - edges, distance, cv::DIST_L2, 3);
  double sum = 0;
  int count = 0;
  for (int v = kReach; v < depth.rows - kReach; ++v) {
    for (int u = kReach; u < depth.cols - kReach; ++u) {
      const int here = depth.at<std::uint16_t>(v, u);
      const int beyond = std::max(
          {depth.at<std::uint16_t>(v, u - kReach), depth.at<std::uint16_t>(v, u + kReach),
           depth.at<std::uint16_t>(v - kReach, u), depth.at<std::uint16_t>(v + kReach, u)});
      if (here == 0 || here > kFarthest || beyond < here + kStep) continue;
      sum += std::min(distance.at<float>(v, u), 10.0F);
      ++count;
    }
  }
  return sum / count;
}

TEST(SevenScenesDataset, RegistrationBringsDepthEdgesToColourEdges) {
  CVO_SLAM_REQUIRE_DATA("7scenes/seq-01");
  const auto folder = test_data() / "7scenes/seq-01";
  const auto registered = open_dataset(folder);
  Camera as_it_is = builtin_camera("7scenes");
  as_it_is.depth.reset();
  const auto unregistered = open_dataset(folder, {.camera = as_it_is});
  double before = 0;
  double after = 0;
  for (const std::size_t i : {0U, 250U, 500U, 750U}) {
    const RgbdFrame frame = registered->read(i);
    after += edge_distance(frame.color, frame.depth) / 4;
    before += edge_distance(frame.color, unregistered->read(i).depth) / 4;
  }
  RecordProperty("before_px", std::to_string(before));
  RecordProperty("after_px", std::to_string(after));
  // Texture has colour edges everywhere: a wrong place is only a few pixels away from one, too.
  EXPECT_LT(after, 0.85 * before);
}

}  // namespace
}  // namespace cvo_slam
