// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string open_error(const TinySequence& sequence) {
  return input_error(sequence.path(), [&] { return sequence.open(); });
}

TEST(OpenDataset, NamesAMissingFolder) {
  EXPECT_THROW(static_cast<void>(open_dataset("/nowhere")), InputError);
  EXPECT_EQ(input_error("/elsewhere", [] { return open_dataset("/nowhere"); }),
            "/nowhere: no such folder; check the path");
}

TEST(OpenDataset, RefusesAFileAndAnUnknownFolder) {
  const TinySequence sequence;
  const auto file = sequence.write("file.txt", "");
  EXPECT_THAT(input_error(sequence.path(), [&] { return open_dataset(file); }),
              HasSubstr("not a folder"));
  EXPECT_THAT(open_error(sequence),
              HasSubstr("is no known data set; the folder of a sequence holds"));
  EXPECT_THAT(open_error(sequence), HasSubstr(dataset_formats()));
}

TEST(OpenDataset, RefusesAnEmptyList) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("depth.txt", "# depth maps\n");
  EXPECT_EQ(open_error(sequence), "depth.txt: lists no image; it needs lines 'stamp file'");
  sequence.write("associations.txt", "\n");
  EXPECT_EQ(open_error(sequence), "associations.txt: lists no image; it needs lines 'stamp file'");
}

TEST(OpenDataset, RefusesListsThatNowherePair) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("depth.txt", "7.00 depth/0.png\n");
  EXPECT_THAT(open_error(sequence), HasSubstr("no image of rgb.txt has one in depth.txt within"));
}

TEST(OpenDataset, NamesTheMalformedLine) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("rgb.txt", "# color\n0.00 rgb/0.png\n0.10\n");
  EXPECT_EQ(open_error(sequence), "rgb.txt:3: expected 'stamp file', found 1 words");
  sequence.write("rgb.txt", "0.00 rgb/0.png\nnan rgb/1.png\n");
  EXPECT_EQ(open_error(sequence),
            "rgb.txt:2: 'nan' is not a time stamp in seconds; repair or remove the line, or begin "
            "it with '#' if it is a heading");
  sequence.write("associations.txt", "0 rgb/0.png 0 depth/0.png\n1 rgb/1.png 1\n");
  EXPECT_EQ(open_error(sequence),
            "associations.txt:2: expected 'stamp file stamp file', found 3 words");
}

// Ground truth is optional: a sequence can be tracked without it.
TEST(OpenDataset, SaysThatTheGroundTruthCannotBeRead) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("groundtruth.txt", "0 0 0 0 0 0 0 1\n1 one 0 0 0 0 0 1\n");
  const auto data = sequence.open();
  EXPECT_TRUE(data->reference().empty());
  EXPECT_THAT(data->notes(), Contains(HasSubstr("the ground truth cannot be read")));
  EXPECT_THAT(data->notes(), Contains(HasSubstr("groundtruth.txt:2: 'one' is not a")));
}

TEST(OpenDataset, ReadsNamesWithBlanksAndLeavesOutOtherColumns) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("rgb.txt", "timestamp filename\n0.00 rgb/my first.png 7 8\n0.10 rgb/1.png 9 9\n");
  sequence.write_color("rgb/my first.png");
  const auto data = sequence.open();
  ASSERT_EQ(data->size(), 2);
  EXPECT_EQ(data->read(0).problem, "");
  EXPECT_THAT(data->notes(), Contains(HasSubstr("rgb.txt: columns behind the names")));
  sequence.write("associations.txt",
                 "0 rgb/my first.png depth/0.png\n1 rgb/1.png 1 depth/1.png x\n");
  EXPECT_EQ(sequence.open()->read(0).problem, "");
  EXPECT_EQ(sequence.open()->read(1).problem, "");
}

TEST(OpenDataset, PairsByAGivenListAndAnOffset) {
  const TinySequence sequence;
  sequence.write_tum();
  const auto list = sequence.write("mine.txt", "0.00 rgb/0.png 0.105 depth/1.png\n");
  DatasetOptions options;
  options.camera = tiny_camera();
  options.associations = list;
  EXPECT_EQ(open_dataset(sequence.path(), options)->read(0).depth_stamp.to_string(), "0.105");
  options.associations.reset();
  options.depth_offset = 0.095;  // the first depth image is now the second colour image's
  const auto data = open_dataset(sequence.path(), options);
  ASSERT_EQ(data->size(), 1);
  EXPECT_EQ(data->stamp(0).to_string(), "0.10");
  EXPECT_EQ(data->depth_stamp(0).to_string(), "0.005");  // the stamp stays as it is
  EXPECT_EQ(data->read(0).depth_stamp, data->depth_stamp(0));
  EXPECT_EQ(data->camera().depth_offset, 0.095);
}

TEST(OpenDataset, TheOffsetOfTheCameraPairsToo) {
  const TinySequence sequence;
  sequence.write_tum();
  DatasetOptions options;
  options.camera = tiny_camera();
  options.camera->depth_offset = 0.095;
  const auto data = open_dataset(sequence.path(), options);
  ASSERT_EQ(data->size(), 1);
  EXPECT_EQ(data->stamp(0).to_string(), "0.10");
  options.depth_offset = 0;  // goes before the camera's
  EXPECT_EQ(open_dataset(sequence.path(), options)->size(), 2);
}

TEST(OpenDataset, WithAnOffsetTwoColourImagesMayShareADepthImage) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("rgb.txt", "0.00 rgb/0.png\n0.01 rgb/1.png\n");
  DatasetOptions options;
  options.camera = tiny_camera();
  EXPECT_EQ(open_dataset(sequence.path(), options)->size(), 1U);
  options.depth_offset = 0.001;
  const auto data = open_dataset(sequence.path(), options);
  ASSERT_EQ(data->size(), 2U);
  EXPECT_EQ(data->depth_stamp(0), data->depth_stamp(1));
  EXPECT_EQ(data->unpaired().color, 0U);
  EXPECT_EQ(data->unpaired().depth, 1U);
}

TEST(OpenDataset, AnOffsetPairsAnewInSpiteOfAListOfPairs) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("associations.txt", "0.00 rgb/0.png 0.005 depth/0.png\n");
  DatasetOptions options;
  options.camera = tiny_camera();
  EXPECT_EQ(open_dataset(sequence.path(), options)->stamp(0).to_string(), "0.00");
  options.depth_offset = 0.095;
  const auto data = open_dataset(sequence.path(), options);
  EXPECT_EQ(data->stamp(0).to_string(), "0.10");
  EXPECT_THAT(data->notes(), Contains(HasSubstr("not by associations.txt")));
}

TEST(OpenDataset, SaysThatImagesLieOutside) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("rgb.txt", "0.00 ../elsewhere/0.png\n0.10 rgb/../rgb/1.png\n");
  EXPECT_THAT(sequence.open()->notes(),
              Contains(HasSubstr("the images of 1 frames lie outside of the folder")));
}

// Motion capture that loses its marker writes such lines; the sequence could not be opened.
TEST(OpenDataset, CountsPosesOfTheGroundTruthThatAreNotFinite) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("groundtruth.txt", "0 0 0 0 0 0 0 1\n1 nan 0 0 0 0 0 1\n");
  const auto data = sequence.open();
  EXPECT_EQ(data->reference().size(), 1U);
  EXPECT_THAT(data->notes(), Contains(StartsWith("groundtruth.txt: 1 of 2 lines have no valid")));
}

TEST(OpenDataset, ReadsListsWithCarriageReturns) {
  const TinySequence sequence;
  sequence.write_tum();
  sequence.write("rgb.txt", "# color\r\n0.00 rgb/0.png\r\n");
  EXPECT_EQ(sequence.open()->read(0).problem, "");
}

/// Each test damages one image of a good sequence and looks at the frames that read() returns.
class BadImage : public testing::Test {
 protected:
  void SetUp() override { sequence_.write_tum(); }

  [[nodiscard]] std::string problem(std::size_t index = 0) const {
    const RgbdFrame frame = sequence_.open()->read(index);
    EXPECT_EQ(frame.problem.empty(), !frame.color.empty());
    EXPECT_EQ(frame.problem.empty(), !frame.depth.empty());
    return input_error(sequence_.path(), [&] { throw Error(frame.problem); });
  }
  /// Keeps the first `bytes` of a file.
  void cut(const std::string& relative, std::size_t bytes) const {
    std::ifstream stream(sequence_.path() / relative, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    ASSERT_GT(text.size(), bytes);
    sequence_.write(relative, text.substr(0, bytes));
  }

  TinySequence sequence_;
};

TEST_F(BadImage, IsMissing) {
  std::filesystem::remove(sequence_.path() / "rgb/0.png");
  EXPECT_EQ(problem(),
            "rgb/0.png: cannot be opened: No such file or directory; check the path and its "
            "permissions");
  EXPECT_EQ(problem(1), "") << "one bad frame must not spoil the next";
}

TEST_F(BadImage, IsAFolder) {
  std::filesystem::remove(sequence_.path() / "depth/0.png");
  std::filesystem::create_directory(sequence_.path() / "depth/0.png");
  EXPECT_EQ(problem(), "depth/0.png: is not a regular file; an image file is needed");
}

TEST_F(BadImage, IsEmptyOrCutOff) {
  cut("rgb/0.png", 40);
  testing::internal::CaptureStderr();
  EXPECT_EQ(problem(), "rgb/0.png: the image file is cut off; record or copy it again");
  sequence_.write("rgb/0.png", "");
  EXPECT_EQ(problem(), "rgb/0.png: the image file is empty; record or copy it again");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "a decoder wrote past the program";
}

TEST_F(BadImage, IsACutJpegWhoseRestTheDecoderWouldPaintGrey) {
  sequence_.write("rgb.txt", "0.00 rgb/0.jpg\n");
  sequence_.write_color("rgb/0.jpg");
  cut("rgb/0.jpg", std::filesystem::file_size(sequence_.path() / "rgb/0.jpg") - 3);
  EXPECT_EQ(problem(), "rgb/0.jpg: the image file is cut off; record or copy it again");
}

TEST_F(BadImage, IsNoImage) {
  sequence_.write("depth/0.png", "this is not a picture");
  EXPECT_EQ(problem(),
            "depth/0.png: is not an image that is read; make it PNG, JPEG, PGM, PPM, BMP or TIFF");
}

TEST_F(BadImage, HasAnotherSizeThanItsPartner) {
  sequence_.write_image("depth/0.png", cv::Mat(3, 4, CV_16UC1, cv::Scalar(5000)));
  EXPECT_EQ(problem(),
            "depth/0.png: the image has 4x3 pixels, its camera 8x6; give the camera of the "
            "recording");
}

TEST_F(BadImage, HasAnotherSizeThanTheCamera) {
  sequence_.write_image("rgb/0.png", cv::Mat(12, 16, CV_8UC3, cv::Scalar(0)));
  EXPECT_EQ(problem(),
            "rgb/0.png: the image has 16x12 pixels, its camera 8x6; give the camera of the "
            "recording");
}

TEST_F(BadImage, HasTheWrongBitDepth) {
  sequence_.write_image("depth/0.png", cv::Mat(6, 8, CV_8UC1, cv::Scalar(50)));
  EXPECT_THAT(problem(),
              EndsWith("must have 16 bits and 1 channel, this one has 8 and 1; convert it"));
  sequence_.write_image("rgb/1.png", cv::Mat(6, 8, CV_16UC3, cv::Scalar(50)));
  EXPECT_THAT(problem(1),
              EndsWith("8 bits and 1, 3 or 4 channels, this one has 16 and 3; convert it"));
}

TEST_F(BadImage, HasNoValidDepth) {
  sequence_.write_depth("depth/0.png", 0);
  EXPECT_EQ(problem(),
            "depth/0.png: the depth image has no valid pixel; see depth_scale of the camera");
}

// Cameras and phones write previews and maker's notes behind the image.
TEST_F(BadImage, IsReadWithBytesBehindItsEnd) {
  const auto append = [&](const std::string& name) {
    std::ofstream(sequence_.path() / name, std::ios::app) << std::string(5000, 'x');
  };
  append("rgb/0.png");
  append("depth/0.png");
  EXPECT_EQ(problem(), "");
  sequence_.write("rgb.txt", "0.00 rgb/0.jpg\n");
  sequence_.write_color("rgb/0.jpg");
  append("rgb/0.jpg");
  EXPECT_EQ(problem(), "");
}

// The picture of a preview within a JPEG file has an end marker of its own.
TEST_F(BadImage, IsCutOffBehindThePreviewOfAJpeg) {
  sequence_.write("rgb.txt", "0.00 rgb/0.jpg\n");
  sequence_.write_color("rgb/0.jpg");
  const std::string image = read_file(sequence_.path() / "rgb/0.jpg");
  const std::string preview = std::string("\xff\xe1\x00\x08", 4) + "ab\xff\xd9xx";
  sequence_.write("rgb/0.jpg", image.substr(0, 2) + preview + image.substr(2));
  EXPECT_EQ(problem(), "");
  sequence_.write("rgb/0.jpg", image.substr(0, 2) + preview + image.substr(2, image.size() - 10));
  EXPECT_EQ(problem(), "rgb/0.jpg: the image file is cut off; record or copy it again");
}

TEST_F(BadImage, IsADeviceWithoutAnEnd) {
  sequence_.write("rgb.txt", "0.00 /dev/zero\n");
  EXPECT_EQ(problem(), "/dev/zero: is not a regular file; an image file is needed");
}

TEST_F(BadImage, IsTooLargeForItsCameraBeforeMemoryIsTaken) {
  std::string image = read_file(sequence_.path() / "rgb/0.png");
  image.replace(16, 8, std::string("\x00\x00\x75\x30\x00\x00\x75\x30", 8));  // 30000 x 30000
  sequence_.write("rgb/0.png", image);
  EXPECT_EQ(problem(),
            "rgb/0.png: the image has 30000x30000 pixels, its camera 8x6; give the camera "
            "of the recording");
}

}  // namespace
}  // namespace cvo_slam
