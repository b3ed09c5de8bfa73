// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <set>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/tests/io/tiny_sequence.h"
#include "cvo_slam/tests/test_data.h"

namespace cvo_slam {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(TumDataset, ReadsFramesWithTheColourStamp) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("groundtruth.txt", "0.00 1 2 3 0 0 0 1\n0.10 1 2 4 0 0 0 1\n");
  const auto data = sequence.open();
  ASSERT_EQ(data->size(), 2);
  EXPECT_EQ(data->kind(), "TUM RGB-D");
  EXPECT_EQ(data->reference().size(), 2);
  EXPECT_THAT(data->notes(), testing::IsEmpty());
  const RgbdFrame frame = data->read(1);
  EXPECT_EQ(frame.problem, "");
  EXPECT_EQ(frame.index, 1);
  EXPECT_EQ(frame.stamp.to_string(), "0.10");
  EXPECT_EQ(frame.stamp, data->stamp(1));
  EXPECT_EQ(frame.depth_stamp.to_string(), "0.105");
  EXPECT_EQ(frame.color.at<cv::Vec3b>(3, 3), cv::Vec3b(10, 20, 30));
  EXPECT_EQ(frame.depth.at<std::uint16_t>(3, 3), 5000);
}

TEST(TumDataset, ReadsJpegAndGreyAndDropsAlpha) {
  const TinySequence sequence;
  sequence.write("associations.txt", "0 a.jpg 0 d.png\n1 grey.png 1 d.png\n2 alpha.png 2 d.png\n");
  sequence.write_depth("d.png");
  sequence.write_color("a.jpg");
  sequence.write_image("grey.png", cv::Mat(6, 8, CV_8UC1, cv::Scalar(7)));
  sequence.write_image("alpha.png", cv::Mat(6, 8, CV_8UC4, cv::Scalar(1, 2, 3, 4)));
  const auto data = sequence.open();
  EXPECT_EQ(data->read(0).color.type(), CV_8UC3);
  EXPECT_EQ(data->read(1).color.type(), CV_8UC1);
  EXPECT_EQ(data->read(2).color.at<cv::Vec3b>(0, 0), cv::Vec3b(1, 2, 3));
}

TEST(TumDataset, LeavesOutAndCountsImagesWithoutPartner) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("rgb.txt", "0.00 rgb/0.png\n0.05 rgb/none.png\n0.10 rgb/1.png\n");
  const auto data = sequence.open();
  EXPECT_EQ(data->size(), 2);
  EXPECT_EQ(data->unpaired().color, 1);
  EXPECT_EQ(data->unpaired().depth, 0);
  EXPECT_THAT(data->notes(), Contains(HasSubstr("1 colour and 0 depth images have no partner")));
}

TEST(TumDataset, TheTolerancePairsMoreOrLess) {
  const TinySequence sequence;
  sequence.write_tum();
  EXPECT_THROW(static_cast<void>(open_dataset(
                   sequence.path(), {.camera = tiny_camera(), .max_stamp_difference = 0.004})),
               InputError);
  EXPECT_THROW(static_cast<void>(open_dataset(
                   sequence.path(), {.camera = tiny_camera(), .max_stamp_difference = -1})),
               OptionError);
}

class AssociationFile : public testing::TestWithParam<const char*> {};

TEST_P(AssociationFile, IsAcceptedInEitherOrder) {
  for (const bool depth_first : {false, true}) {
    const TinySequence sequence;
    const std::string color = "0.5 rgb/0.png";
    const std::string depth = "0.7 depth/0.png";  // more than 20 ms apart: the list decides
    const auto& [first, second] = depth_first ? std::pair(depth, color) : std::pair(color, depth);
    sequence.write(GetParam(), fmt::format("{} {}", first, second));
    sequence.write_color("rgb/0.png");
    sequence.write_depth("depth/0.png");
    const RgbdFrame frame = sequence.open()->read(0);
    EXPECT_EQ(frame.problem, "");
    EXPECT_EQ(frame.stamp.to_string(), "0.5");
    EXPECT_EQ(frame.depth_stamp.to_string(), "0.7");
  }
}

INSTANTIATE_TEST_SUITE_P(AllNames, AssociationFile,
                         testing::Values("associations.txt", "associated.txt", "associate.txt"));

TEST(TumDataset, OpensTheImagesWhereTheirNamesDoNotTellWhichIsDepth) {
  for (const bool depth_first : {false, true}) {
    const TinySequence sequence;
    sequence.write("associations.txt", depth_first ? "0 b/0.png 0 a/0.png" : "0 a/0.png 0 b/0.png");
    sequence.write_color("a/0.png");
    sequence.write_depth("b/0.png");
    EXPECT_EQ(sequence.open()->read(0).problem, "");
  }
  const TinySequence sequence;
  sequence.write("associations.txt", "0 a/0.png 0 b/0.png");
  EXPECT_THAT(input_error(sequence.path(), [&] { return sequence.open(); }),
              StartsWith("associations.txt:1: cannot tell the depth image"));
}

TEST(TumDataset, AnAssociationFileGoesBeforeTheLists) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("associations.txt", "0.10 rgb/1.png 0.105 depth/1.png\n");
  const auto data = sequence.open();
  EXPECT_EQ(data->size(), 1);
  EXPECT_THAT(data->notes(), Contains("frames are paired by associations.txt"));
}

TEST(TumDataset, SortsStampsOutOfOrder) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("rgb.txt", "0.10 rgb/1.png\n0.00 rgb/0.png\n");
  sequence.write("groundtruth.txt", "0.10 0 0 0 0 0 0 1\n0.00 0 0 0 0 0 0 1\n");
  const auto data = sequence.open();
  EXPECT_EQ(data->stamp(0).to_string(), "0.00");
  EXPECT_EQ(data->reference().front().stamp.to_string(), "0.00");
  EXPECT_THAT(data->notes(), ElementsAre("rgb.txt: stamps out of order; sorted",
                                         "groundtruth.txt: stamps out of order; sorted"));
}

TEST(TumDataset, DropsTheLaterOfDuplicatedStamps) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("rgb.txt", "0.00 rgb/0.png\n0.00 rgb/missing.png\n0.10 rgb/1.png\n");
  sequence.write("groundtruth.txt", "0.00 1 0 0 0 0 0 1\n0.00 2 0 0 0 0 0 1\n");
  const auto data = sequence.open();
  EXPECT_EQ(data->size(), 2);
  EXPECT_EQ(data->read(0).problem, "");
  EXPECT_EQ(data->reference().size(), 1);
  EXPECT_EQ(data->reference()[0].T_world_camera.translation().x(), 1);
  EXPECT_THAT(data->notes(), Contains(StartsWith("rgb.txt: 1 duplicated stamps")));
  EXPECT_THAT(data->notes(), Contains(StartsWith("groundtruth.txt: 1 duplicated stamps")));
}

TEST(TumDataset, OpensWithoutGroundTruth) {
  const TinySequence sequence;
  sequence.write_tum();
  const auto data = sequence.open();
  EXPECT_TRUE(data->reference().empty());
  EXPECT_THAT(data->notes(), Contains(StartsWith("no ground truth")));
}

TEST(TumDataset, TakesACameraFileInTheFolder) {
  const TinySequence sequence;
  sequence.write_tum();
  write_camera(sequence.path() / "camera.yaml", tiny_camera());
  const auto data = open_dataset(sequence.path());
  EXPECT_EQ(data->camera().name, "tiny");
  EXPECT_EQ(data->camera_origin(), "camera.yaml in the folder of the sequence");
  EXPECT_EQ(sequence.open()->camera_origin(), "given by the caller");
}

TEST(TumDataset, TakesTheCameraFromTheRecordingsNameInTheList) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("rgb.txt",
                 "# color images\n# file: 'rgbd_dataset_freiburg2_desk.bag'\n0.00 rgb/0.png\n");
  const auto data = open_dataset(sequence.path());
  EXPECT_EQ(data->camera().name, "tum_fr2");
  EXPECT_EQ(data->camera_origin(),
            "rgb.txt says that the recording is 'rgbd_dataset_freiburg2_desk.bag'");
}

TEST(TumDataset, RefusesToGuessACamera) {
  const TinySequence sequence;
  sequence.write_tum();
  EXPECT_THAT(input_error(sequence.path(), [&] { return open_dataset(sequence.path()); }),
              testing::AllOf(HasSubstr("give --camera"), HasSubstr("tum_fr1, tum_fr2, tum_fr3")));
}

TEST(TumDataset, ReturnsTheSameToManyThreads) {
  const TinySequence sequence;
  sequence.write_tum();
  const auto data = sequence.open();
  const cv::Mat expected = data->read(0).color;
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 16; ++k) EXPECT_EQ(cv::norm(data->read(0).color, expected), 0);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

/// Returns the first word of each line of a list.
std::set<std::string> listed_stamps(const std::filesystem::path& list) {
  std::ifstream stream(list);
  std::set<std::string> stamps;
  for (std::string line, word; std::getline(stream, line);) {
    if (std::istringstream(line) >> word && word != "#") stamps.insert(word);
  }
  return stamps;
}

TEST(TumDataset, ReadsFreiburg1Rpy) {
  CVO_SLAM_REQUIRE_DATA("tum/rgbd_dataset_freiburg1_rpy");
  const auto folder = test_data() / "tum/rgbd_dataset_freiburg1_rpy";
  const auto data = open_dataset(folder);
  // 723 colour and 722 depth images; 694 is what the published evaluations of this sequence use.
  EXPECT_EQ(data->size(), 694);
  EXPECT_EQ(data->unpaired().color, 723 - 694);
  EXPECT_EQ(data->unpaired().depth, 722 - 694);
  EXPECT_EQ(data->camera().name, "tum_fr1");
  EXPECT_EQ(data->name(), "rgbd_dataset_freiburg1_rpy");
  EXPECT_FALSE(data->reference().empty());
  const auto stamps = listed_stamps(folder / "rgb.txt");
  for (std::size_t i = 0; i < data->size(); ++i) {
    EXPECT_EQ(stamps.count(data->stamp(i).to_string()), 1) << i;
  }
  EXPECT_EQ(data->read(0).problem, "");
  EXPECT_EQ(data->read(693).problem, "");
}

}  // namespace
}  // namespace cvo_slam
