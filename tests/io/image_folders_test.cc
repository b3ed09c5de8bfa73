// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct OpenedFolders {
  std::vector<std::string> stamps;
  std::vector<std::string> notes;
};

/// Opens image files of these names.
OpenedFolders open_names(const std::vector<std::string>& colors,
                         const std::vector<std::string>& depths) {
  const TinySequence sequence;
  for (const auto& name : colors) sequence.write_color(name);
  for (const auto& name : depths) sequence.write_depth(name);
  const auto data = sequence.open();
  EXPECT_EQ(data->kind(), "image folders");
  OpenedFolders result{{}, data->notes()};
  for (std::size_t i = 0; i < data->size(); ++i) {
    EXPECT_EQ(data->read(i).problem, "");
    result.stamps.push_back(data->stamp(i).to_string());
  }
  return result;
}

std::string open_problem(const std::vector<std::string>& colors,
                         const std::vector<std::string>& depths) {
  const TinySequence sequence;
  for (const auto& name : colors) sequence.write_color(name);
  for (const auto& name : depths) sequence.write_depth(name);
  return input_error(sequence.path(), [&] { return sequence.open(); });
}

// Sorted as text, 10 would come before 9.
TEST(ImageFolders, NumbersAreFramesAtThirtyHertzAndTheGuessIsSaid) {
  const auto data = open_names({"rgb/9.png", "rgb/10.png", "rgb/12.png"},
                               {"depth/9.png", "depth/10.png", "depth/11.png"});
  EXPECT_THAT(data.stamps, ElementsAre("0.300000", "0.333333"));
  EXPECT_THAT(data.notes, testing::Contains(HasSubstr("at 30 Hz; --frame-rate sets it")));
  EXPECT_THAT(data.notes, testing::Contains("1 colour and 1 depth images have no partner and are "
                                            "left out"));
}

TEST(ImageFolders, TakesTheLastNumberOfAName) {
  const auto data =
      open_names({"color/cam0_frame_0003_rgb.jpg", "color/cam0_frame_0006_rgb.jpg"},
                 {"depth/cam0_frame_0003_depth.png", "depth/cam0_frame_0006_depth.png"});
  EXPECT_THAT(data.stamps, ElementsAre("0.100000", "0.200000"));
}

// The last number would be the same in all.
TEST(ImageFolders, TakesTheLastNumberThatDiffers) {
  const auto data = open_names({"rgb/frame_0003_rgb8.png", "rgb/frame_0006_rgb8.png"},
                               {"depth/frame_0003_z16.png", "depth/frame_0006_z16.png"});
  EXPECT_THAT(data.stamps, ElementsAre("0.100000", "0.200000"));
}

TEST(ImageFolders, NumbersWithAFractionAreSeconds) {
  const auto data = open_names({"rgb/1305031102.1753.png", "rgb/1305031102.2111.png"},
                               {"depth/1305031102.1604.png", "depth/1305031102.2263.png"});
  EXPECT_THAT(data.stamps, ElementsAre("1305031102.1753", "1305031102.2111"));
  EXPECT_THAT(data.notes, testing::Contains(HasSubstr("names of the images, in seconds")));
}

TEST(ImageFolders, LargeNumbersAreTimesInTheUnitThatGivesAYear) {
  EXPECT_THAT(open_names({"rgb/1403636579763555584.png"}, {"depth/1403636579763555584.png"}).stamps,
              ElementsAre("1403636579.763555584"));
  EXPECT_THAT(open_names({"rgb/1403636579763555.png"}, {"depth/1403636579763999.png"}).stamps,
              ElementsAre("1403636579.763555"));
  const auto data = open_names({"rgb/1403636579763.png"}, {"depth/1403636579763.png"});
  EXPECT_THAT(data.stamps, ElementsAre("1403636579.763"));
  EXPECT_THAT(data.notes, testing::Contains(HasSubstr("in milliseconds")));
}

TEST(ImageFolders, LeavesOutWhatHasNoNumberOrThatOfAnother) {
  const auto data = open_names({"rgb/1.png", "rgb/01.png", "rgb/mask.png"}, {"depth/1.png"});
  EXPECT_THAT(data.stamps, ElementsAre("0.033333"));
  EXPECT_THAT(data.notes, testing::Contains(HasSubstr("rgb: 1 images have no number")));
  EXPECT_THAT(data.notes, testing::Contains(HasSubstr("rgb: 1 images have the number of another")));
}

TEST(ImageFolders, SaysWhatCannotBePaired) {
  EXPECT_THAT(open_problem({"rgb/a.png"}, {"depth/a.png"}), HasSubstr("list them in rgb.txt"));
  EXPECT_THAT(open_problem({"rgb/1.png"}, {"depth/1.5.png"}),
              HasSubstr("colour images count frames and those of the depth images seconds"));
  EXPECT_THAT(open_problem({"rgb/1.png"}, {"depth/2.png"}), HasSubstr("within 0.02 s"));
  EXPECT_THAT(open_problem({"rgb/99999999999999999999999.png"}, {"depth/1.png"}),
              HasSubstr("is no time in frames"));
  EXPECT_THAT(open_problem({"rgb/1403636579763.png", "rgb/9223372036854775807.png"},
                           {"depth/1403636579763.png"}),
              HasSubstr("is no time in milliseconds"));
}

TEST(ImageFolders, AreNotReadWhileAListIsMissing) {
  const TinySequence sequence;
  sequence.write("rgb.txt", "0.1 rgb/1.png\n");
  sequence.write_color("rgb/1.png");
  sequence.write_depth("depth/1.png");
  EXPECT_THAT(input_error(sequence.path(), [&] { return sequence.open(); }),
              HasSubstr("is no known data set"));
}

TEST(ImageFolders, ListsComeFirst) {
  const TinySequence sequence;
  sequence.write_tum();
  EXPECT_EQ(sequence.open()->kind(), "TUM RGB-D");
}

}  // namespace
}  // namespace cvo_slam
