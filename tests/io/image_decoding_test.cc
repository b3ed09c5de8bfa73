// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/io/image_decoding_internal.h"

namespace cvo_slam {
namespace {

cv::Mat random_image(int type) {
  cv::Mat image(37, 53, type);
  cv::RNG random(7);
  random.fill(image, cv::RNG::UNIFORM, 0, image.depth() == CV_16U ? 65536 : 256);
  return image;
}

std::string encoded(const cv::Mat& image, const std::string& kind,
                    const std::vector<int>& parameters = {}) {
  std::vector<unsigned char> bytes;
  EXPECT_TRUE(cv::imencode(kind, image, bytes, parameters));
  return {bytes.begin(), bytes.end()};
}

/// Expects what OpenCV makes of the same bytes.
void expect_as_opencv(const std::string& bytes) {
  const std::vector<unsigned char> copy(bytes.begin(), bytes.end());
  const cv::Mat expected = cv::imdecode(copy, cv::IMREAD_UNCHANGED);
  const cv::Mat image = decode_image(bytes);
  ASSERT_EQ(image.type(), expected.type());
  ASSERT_EQ(image.size(), expected.size());
  EXPECT_TRUE(image.empty() || cv::norm(image, expected, cv::NORM_INF) == 0);
}

TEST(ImageDecoding, OfEveryKindIsThatOfOpenCv) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    expect_as_opencv(encoded(random_image(type), ".jpg"));
    expect_as_opencv(encoded(random_image(type), ".jpg", {cv::IMWRITE_JPEG_PROGRESSIVE, 1}));
    expect_as_opencv(encoded(random_image(type), ".jpg", {cv::IMWRITE_JPEG_QUALITY, 30}));
    expect_as_opencv(encoded(random_image(type), ".png"));
  }
  expect_as_opencv(encoded(random_image(CV_16UC1), ".png"));
  expect_as_opencv(encoded(random_image(CV_8UC4), ".png"));
}

TEST(ImageDecoding, OfDamagedFilesIsThatOfOpenCv) {
  const std::string whole = encoded(random_image(CV_8UC3), ".jpg");
  std::string noisy = whole;
  noisy.insert(2, "between the segments");
  expect_as_opencv(noisy);
  std::string cut = whole.substr(0, whole.size() / 2);
  expect_as_opencv(cut);
  expect_as_opencv(cut + "\xff\xd9");
  EXPECT_TRUE(decode_image("\xff\xd8 no image").empty());
  EXPECT_TRUE(decode_image("no image").empty());
}

}  // namespace
}  // namespace cvo_slam
