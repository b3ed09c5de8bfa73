// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/loop_pictures.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const cv::Mat kGrey(60, 80, CV_8UC1, cv::Scalar(90));
const cv::Mat kGreyInColor(60, 80, CV_8UC3, cv::Scalar::all(90));

bool is_grey(const cv::Mat& picture, int x, int y) {
  return picture.at<cv::Vec3b>(y, x) == cv::Vec3b(90, 90, 90);
}

TEST(MatchPicture, JoinsEachPointWithItsPartner) {
  const cv::Mat picture = draw_matches(kGrey, kGreyInColor, {{10, 20, 30, 20}}, 1000);
  ASSERT_EQ(picture.size(), cv::Size(80 + 8 + 80, 60)) << "8 pixels are between the images";
  EXPECT_FALSE(is_grey(picture, 10, 20)) << "its point in the first image";
  EXPECT_FALSE(is_grey(picture, 88 + 30, 20)) << "its point in the second one";
  EXPECT_FALSE(is_grey(picture, 50, 20)) << "the line between";
  EXPECT_FALSE(is_grey(picture, 88 + 15, 20));
  EXPECT_TRUE(is_grey(picture, 88 + 45, 20)) << "beyond its end";
  EXPECT_TRUE(is_grey(picture, 50, 40));
}

TEST(MatchPicture, IsShrunkWithItsPoints) {
  const cv::Mat picture = draw_matches(kGrey, kGrey, {{40, 40, 40, 40}}, 84);
  ASSERT_EQ(picture.size(), cv::Size(84, 30));
  EXPECT_FALSE(is_grey(picture, 20, 20));
  EXPECT_FALSE(is_grey(picture, 44 + 20, 20));
  EXPECT_TRUE(is_grey(picture, 10, 10));
}

TEST(MatchPicture, TakesImagesOfAnySizeAndNone) {
  const cv::Mat small(20, 30, CV_8UC3, cv::Scalar::all(90));
  EXPECT_EQ(draw_matches(kGrey, small, {}, 1000).size(), cv::Size(80 + 8 + 30, 60));
  EXPECT_EQ(draw_matches(kGrey, {}, {}, 1000).size(), cv::Size(80 + 8 + 80, 60));
  EXPECT_FALSE(draw_matches({}, {}, {{1e6F, -1e6F, 0, 0}}, 1000).empty());
}

/// Images of one colour each; the fourth cannot be read.
class FewImages : public Dataset {
 public:
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] const std::string& kind() const override { return name_; }
  [[nodiscard]] const Camera& camera() const override { return camera_; }
  [[nodiscard]] const std::string& camera_origin() const override { return name_; }
  [[nodiscard]] std::size_t size() const override { return 5; }
  [[nodiscard]] RgbdFrame read(std::size_t index) const override {
    RgbdFrame frame;
    frame.index = index;
    if (index == 3) {
      frame.problem = "rgb/3.png: broken";
    } else {
      frame.color = cv::Mat(60, 80, CV_8UC3, cv::Scalar::all(30 * static_cast<double>(index)));
    }
    return frame;
  }
  [[nodiscard]] Timestamp depth_stamp(std::size_t index) const override { return stamp(index); }
  [[nodiscard]] Timestamp stamp(std::size_t index) const override {
    return Timestamp::from_seconds(static_cast<double>(index));
  }
  [[nodiscard]] UnpairedImages unpaired() const override { return {}; }
  [[nodiscard]] const std::vector<StampedPose>& reference() const override { return reference_; }
  [[nodiscard]] const std::vector<std::string>& notes() const override { return notes_; }

 private:
  std::string name_ = "few";
  Camera camera_;
  std::vector<StampedPose> reference_;
  std::vector<std::string> notes_;
};

class LoopPicturesOfARun : public testing::Test {
 protected:
  LoopPicturesOfARun() {
    add(EdgeKind::kProximity, 0, 1, true, 9);
    add(EdgeKind::kLoop, 0, 2, true, 0.1);
    add(EdgeKind::kLoop, 1, 2, false, 0.3);
    add(EdgeKind::kLoop, 0, 4, true, 0.2);
  }

  void add(EdgeKind kind, std::size_t from, std::size_t to, bool accepted, double correction) {
    LoopCandidate candidate;
    candidate.kind = kind;
    candidate.from = from;
    candidate.to = to;
    candidate.accepted = accepted;
    candidate.correction_translation = correction;
    candidate.pixels = {{10, 20, 30, 20}};
    candidates_.push_back(candidate);
  }

  LoopGallery write(LoopPictures which, std::size_t max_chosen = 10) {
    return write_loop_pictures(folder_.path(), FewImages(), candidates_, which, max_chosen, notes_);
  }

  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    if (!std::filesystem::exists(folder_.path() / "loops")) return names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "loops")) {
      names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  TemporaryFolder folder_;
  std::vector<LoopCandidate> candidates_;
  std::vector<std::string> notes_;
};

TEST_F(LoopPicturesOfARun, AreOfAcceptedOnesThatWereRecognised) {
  const LoopGallery gallery = write(LoopPictures::kAccepted);
  EXPECT_EQ(gallery.files, 2U);
  EXPECT_THAT(files(), ElementsAre("accepted_000000_000002.png", "accepted_000000_000004.png"));
  const cv::Mat picture = cv::imread(folder_.path() / "loops" / files()[0]);
  ASSERT_EQ(picture.size(), cv::Size(168, 60));
  EXPECT_EQ(picture.at<cv::Vec3b>(50, 5), cv::Vec3b(0, 0, 0)) << "frame 0 is on the left";
  EXPECT_EQ(picture.at<cv::Vec3b>(50, 160), cv::Vec3b(60, 60, 60)) << "frame 2 is on the right";
  EXPECT_TRUE(notes_.empty());
}

TEST_F(LoopPicturesOfARun, AreOfAllOnDemandOrOfNone) {
  EXPECT_EQ(write(LoopPictures::kNone).files, 0U);
  EXPECT_TRUE(files().empty());
  EXPECT_EQ(write(LoopPictures::kAll).files, 3U);
  EXPECT_THAT(files(), ElementsAre("accepted_000000_000002.png", "accepted_000000_000004.png",
                                   "rejected_000001_000002.png"));
}

TEST_F(LoopPicturesOfARun, APageGetsThoseThatCorrectedMost) {
  const LoopGallery one = write(LoopPictures::kAll, 1);
  EXPECT_EQ(one.files, 3U);
  ASSERT_EQ(one.chosen.size(), 1U);
  EXPECT_EQ(one.chosen[0].candidate.to, 4U);
  EXPECT_EQ(one.chosen[0].jpeg.substr(0, 2), "\xFF\xD8");
  const LoopGallery all = write(LoopPictures::kAll, 3);
  ASSERT_EQ(all.chosen.size(), 3U);
  EXPECT_EQ(all.chosen[0].candidate.to, 2U) << "in the order of the frames";
}

TEST_F(LoopPicturesOfARun, AnImageThatCannotBeReadIsSaid) {
  add(EdgeKind::kLoop, 0, 3, true, 0.1);
  EXPECT_EQ(write(LoopPictures::kAccepted).files, 3U);
  EXPECT_THAT(notes_, ElementsAre("no picture of frame 3 of a loop: rgb/3.png: broken"));
}

TEST_F(LoopPicturesOfARun, AreRemovedWithoutWhatIsNotTheirs) {
  EXPECT_EQ(write(LoopPictures::kAll).files, 3U);
  folder_.write("loops/accepted_by_me.png", "mine");
  remove_loop_pictures(folder_.path());
  EXPECT_THAT(files(), ElementsAre("accepted_by_me.png"));
  std::filesystem::remove_all(folder_.path() / "loops");
  EXPECT_EQ(write(LoopPictures::kAll).files, 3U);
  remove_loop_pictures(folder_.path());
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "loops"));
  remove_loop_pictures(folder_.path());  // nothing to do is no error
}

TEST_F(LoopPicturesOfARun, AFileInTheWayIsAnError) {
  folder_.write("loops", "a file");
  EXPECT_THROW(static_cast<void>(write(LoopPictures::kAll)), OutputError);
}

}  // namespace
}  // namespace cvo_slam
