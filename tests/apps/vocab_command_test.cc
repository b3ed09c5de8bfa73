// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/loop/vocabulary.h"
#include "cvo_slam/tests/apps/run_program.h"
#include "cvo_slam/tests/loop/poster_frames.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

class VocabCommand : public testing::Test {
 protected:
  /// Makes a folder of pictures that is no data set.
  VocabCommand() {
    std::filesystem::create_directories(pictures_);
    const Poster poster(1);
    for (int i = 0; i < 6; ++i) {
      const auto file = pictures_ / (std::to_string(i) + ".png");
      cv::imwrite(file, poster.frame(0, 300 * i, 100).color);
    }
  }

  [[nodiscard]] static ProgramResult train(const std::string& output,
                                           const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"vocab", "train", "-o", output, "-k", "4", "-L", "3"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }

  TemporaryFolder folder_;
  std::filesystem::path pictures_ = folder_.path() / "pictures";
  std::string binary_ = folder_.path() / "words.voc";
  std::string text_ = folder_.path() / "words.txt";
};

TEST_F(VocabCommand, TrainsFromPicturesAndWorldsToTheSameByte) {
  const std::string again = folder_.path() / "again.voc";
  const ProgramResult first =
      train(binary_, {pictures_, "synth:room:900", "--step", "2", "--rate", "0.1"});
  EXPECT_EQ(first.exit_code, 0) << first.errors;
  // Three of the six pictures, and one of the ten seconds of the room.
  EXPECT_THAT(first.output, HasSubstr("in 4 images"));
  EXPECT_EQ(train(again, {pictures_, "synth:room:900", "--step", "2", "--rate", "0.1", "--threads",
                          "1", "--quiet"})
                .output,
            "");
  EXPECT_EQ(read_text(binary_), read_text(again));
  const Vocabulary vocabulary = read_vocabulary(binary_);
  EXPECT_EQ(vocabulary.branching(), 4);
  EXPECT_EQ(vocabulary.levels(), 3);
  EXPECT_GT(vocabulary.words(), 50U);
}

TEST_F(VocabCommand, ConvertsBothWays) {
  ASSERT_EQ(train(binary_, {pictures_}).exit_code, 0);
  EXPECT_EQ(run_program({"vocab", "convert", binary_, text_}).exit_code, 0);
  EXPECT_THAT(read_text(text_), testing::StartsWith("4 3 0 0\n"));
  const std::string back = folder_.path() / "back.voc";
  EXPECT_EQ(run_program({"vocab", "convert", text_, back}).exit_code, 0);
  EXPECT_EQ(read_text(back), read_text(binary_));
}

TEST_F(VocabCommand, InfoIsOfTheBuiltInOneOrAFile) {
  const ProgramResult built_in = run_program({"vocab", "info", "--json"});
  ASSERT_EQ(built_in.exit_code, 0) << built_in.errors;
  const auto json = nlohmann::json::parse(built_in.output);
  EXPECT_EQ(json["name"], "built in");
  EXPECT_GT(json["words"], 50000);
  EXPECT_LE(json["binary_bytes"], 4'000'000);
  ASSERT_EQ(train(text_, {pictures_}).exit_code, 0);
  const ProgramResult of_file = run_program({"vocab", "info", text_});
  EXPECT_THAT(of_file.output, HasSubstr("branching       4\n"));
}

/// The built-in vocabulary is the file in config/vocabulary/.
TEST_F(VocabCommand, TheBuiltInOneIsTheOneOfTheRepository) {
  const auto file = std::filesystem::path(CVO_SLAM_SOURCE_DIR) / "config/vocabulary/orb.voc";
  const ProgramResult of_file = run_program({"vocab", "info", file, "--json"});
  const ProgramResult built_in = run_program({"vocab", "info", "--json"});
  auto a = nlohmann::json::parse(of_file.output);
  auto b = nlohmann::json::parse(built_in.output);
  for (auto* json : {&a, &b}) {
    json->erase("name");
    json->erase("load_ms");
  }
  EXPECT_EQ(a, b);
}

TEST_F(VocabCommand, MistakesAreSaidInOneLine) {
  const auto problem = [&](const std::vector<std::string>& arguments) {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    return result.errors;
  };
  EXPECT_THAT(problem({"vocab"}), HasSubstr("train, convert, info"));
  EXPECT_THAT(problem({"vocab", "train", "-o", binary_, "synth:room"}),
              HasSubstr("must be synth:<world>:<seed>"));
  EXPECT_THAT(problem({"vocab", "train", "-o", binary_, "synth:rom:900"}), HasSubstr("'room'"));
  EXPECT_THAT(problem({"vocab", "train", "-o", binary_, pictures_, "-k", "1"}),
              HasSubstr("branching"));
  EXPECT_THAT(problem({"vocab", "info", folder_.path() / "none.voc"}), HasSubstr("none.voc"));
  EXPECT_THAT(problem({"vocab", "convert", pictures_ / "0.png", text_}),
              HasSubstr("is no vocabulary"));
}

}  // namespace
}  // namespace cvo_slam
