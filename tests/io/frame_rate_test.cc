// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The frame rate of recordings whose images are numbered.
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Camera small_camera() {
  Camera camera = tiny_camera();
  camera.color.width = 160;
  camera.color.height = 120;
  camera.color.fx = camera.color.fy = 130;
  camera.color.cx = 79.5;
  camera.color.cy = 59.5;
  return camera;
}

/// Twenty images of a camera that passes a wall of blots by `step` pixels from image to image.
class NumberedFrames {
 public:
  explicit NumberedFrames(int step, const std::string& color = "rgb/{:06}.png",
                          const std::string& depth = "depth/{:06}.png") {
    cv::Mat wall(120, 160 + 20 * step, CV_8UC3);
    cv::RNG(7).fill(wall, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(wall, wall, {}, 4);
    for (int i = 0; i < 20; ++i) {
      sequence_.write_image(fmt::format(fmt::runtime(color), i),
                            wall(cv::Rect(i * step, 0, 160, 120)));
      sequence_.write_image(fmt::format(fmt::runtime(depth), i),
                            cv::Mat(120, 160, CV_16UC1, cv::Scalar(5000)));
    }
  }

  [[nodiscard]] std::unique_ptr<Dataset> open(std::optional<double> frame_rate = {}) const {
    return open_dataset(sequence_.path(), {.camera = small_camera(), .frame_rate = frame_rate});
  }

 private:
  TinySequence sequence_;
};

double seconds_of_last(const Dataset& data) {
  return seconds_between(data.stamp(0), data.stamp(data.size() - 1));
}

TEST(FrameRate, IsThirtyHertzWhereThatCanBe) {
  const auto data = NumberedFrames(1).open();  // 0.008 rad a frame
  EXPECT_NEAR(seconds_of_last(*data), 19 / 30.0, 1e-6);
  EXPECT_THAT(data->notes(), Not(Contains(HasSubstr("is assumed"))));
}

TEST(FrameRate, IsLowerWhereTheCameraTurnsFarFromImageToImage) {
  const auto data = NumberedFrames(12).open();  // 0.092 rad a frame
  EXPECT_NEAR(seconds_of_last(*data), 19 / 3.0, 1e-5);
  EXPECT_THAT(data->notes(), Contains(testing::ContainsRegex(
                                 "frame rate: 3 Hz is assumed, because the image turns by 5.. "
                                 "degrees from frame to frame, too fast for 30 Hz")));
}

TEST(FrameRate, OfSevenScenesTooIsThatOfTheImages) {
  const NumberedFrames frames(12, "frame-{:06}.color.png", "frame-{:06}.depth.png");
  const auto data = frames.open();
  EXPECT_EQ(data->kind(), "7-Scenes");
  EXPECT_NEAR(seconds_of_last(*data), 19 / 3.0, 1e-5);
}

/// Twenty images, each of its own noise over the same grey.
std::unique_ptr<Dataset> open_noise(int grey, int noise) {
  const TinySequence sequence;
  cv::RNG random(3);
  for (int i = 0; i < 20; ++i) {
    cv::Mat image(120, 160, CV_8UC3);
    random.fill(image, cv::RNG::NORMAL, grey, noise);
    sequence.write_image(fmt::format("rgb/{}.png", i), image);
    sequence.write_image(fmt::format("depth/{}.png", i),
                         cv::Mat(120, 160, CV_16UC1, cv::Scalar(5000)));
  }
  return open_dataset(sequence.path(), {.camera = small_camera()});
}

TEST(FrameRate, IsThirtyHertzWhereTheImagesDoNotTell) {
  for (const auto& [grey, noise] : {std::pair{0, 0}, {90, 5}, {120, 40}}) {
    const auto data = open_noise(grey, noise);
    EXPECT_NEAR(seconds_of_last(*data), 19 / 30.0, 1e-6) << grey << " +- " << noise;
  }
}

TEST(FrameRate, ThatIsGivenIsTaken) {
  EXPECT_NEAR(seconds_of_last(*NumberedFrames(12).open(12.5)), 19 / 12.5, 1e-5);
  for (const double rate : {0.0, -1.0, 1e4, std::nan("")}) {
    EXPECT_THROW(static_cast<void>(NumberedFrames(1).open(rate)), OptionError) << rate;
  }
}

}  // namespace
}  // namespace cvo_slam
