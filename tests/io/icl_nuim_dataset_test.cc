// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/tests/io/tiny_sequence.h"
#include "cvo_slam/tests/test_data.h"

namespace cvo_slam {
namespace {

/// Writes two frames with integer stamps and depth first.
void write_icl_nuim(const TinySequence& sequence) {
  sequence.write("associations.txt", "1 depth/1.png 1 rgb/1.png\n2 depth/2.png 2 rgb/2.png\n");
  for (const char* name : {"1.png", "2.png"}) {
    sequence.write_color(std::string("rgb/") + name);
    sequence.write_depth(std::string("depth/") + name);
  }
}

TEST(IclNuimDataset, ReadsItsListAndReference) {
  const TinySequence sequence;
  write_icl_nuim(sequence);
  sequence.write("livingRoom2.gt.freiburg", "1 0 0 -2.5 0 0 0 1\n");
  const auto data = sequence.open();
  EXPECT_EQ(data->stamp(1).to_string(), "2");
  EXPECT_EQ(data->reference().size(), 1);
  EXPECT_EQ(data->read(0).problem, "");
  EXPECT_THAT(data->notes(), testing::Contains(testing::HasSubstr("stamps are frame numbers")));
}

TEST(IclNuimDataset, AMistakeInItsListIsReported) {
  const TinySequence sequence;
  write_icl_nuim(sequence);
  sequence.write("associations.txt", "1 depth/1.png 1 rgb/1.png\n2 depth/2.png\n");
  EXPECT_EQ(input_error(sequence.path(), [&] { return sequence.open(); }),
            "associations.txt:2: expected 'stamp file stamp file', found 2 words");
}

/// Returns the mean difference of the grey levels of a and b at the points of a: a measure of how
/// well depth, camera and motion agree. (The depth of this sequence is noisy and says less.)
double photometric_error(const PinholeCamera& camera, const RgbdFrame& a, const RgbdFrame& b,
                         const SE3& T_b_a) {
  cv::Mat grey_a;
  cv::Mat grey_b;
  cv::Mat seen_b;
  cv::cvtColor(a.color, grey_a, cv::COLOR_BGR2GRAY);
  cv::cvtColor(b.color, grey_b, cv::COLOR_BGR2GRAY);
  cv::Mat map(a.color.size(), CV_32FC2, cv::Scalar(-1, -1));
  for (int v = 0; v < map.rows; ++v) {
    for (int u = 0; u < map.cols; ++u) {
      const double depth = a.depth.at<std::uint16_t>(v, u) / 5000.0;
      if (depth == 0) continue;
      const auto pixel = camera.project(T_b_a * (depth * camera.unproject({u, v})));
      map.at<cv::Vec2f>(v, u) = cv::Vec2d(pixel.x(), pixel.y());
    }
  }
  // Pixels that map to the outside of b keep the grey of a: their difference is 0 in every case.
  grey_a.copyTo(seen_b);
  cv::remap(grey_b, seen_b, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_TRANSPARENT);
  return cv::norm(grey_a, seen_b, cv::NORM_L1) / static_cast<double>(grey_a.total());
}

TEST(IclNuimDataset, ImagesAgreeWithTheReferenceWhereYPointsUp) {
  CVO_SLAM_REQUIRE_DATA("fixtures/icl_nuim");
  const auto data = open_dataset(test_data() / "fixtures/icl_nuim");
  ASSERT_EQ(data->size(), 6);
  ASSERT_EQ(data->reference().size(), 6);
  const PinholeCamera camera = data->camera().color;
  EXPECT_EQ(camera.fy, -480);
  PinholeCamera y_down = camera;
  y_down.fy = 480;
  const RgbdFrame first = data->read(0);
  const RgbdFrame last = data->read(5);
  const SE3 T_last_first =
      data->reference()[5].T_world_camera.inverse() * data->reference()[0].T_world_camera;
  const double aligned = photometric_error(camera, first, last, T_last_first);
  // The noise of the images is 2 grey levels; without the motion the error is 5.7, with y down 6.
  EXPECT_LT(aligned, 2.5);
  EXPECT_GT(photometric_error(camera, first, last, SE3()), 2 * aligned);
  EXPECT_GT(photometric_error(y_down, first, last, T_last_first), 2 * aligned);
}

}  // namespace
}  // namespace cvo_slam
