// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// `cvo_slam render` on a machine without a libOSMesa that works.
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/tests/apps/run_program.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

/// Makes started programs look for libraries in a folder first.
class LibraryFolder {
 public:
  explicit LibraryFolder(const std::filesystem::path& folder) {
    if (const char* before = std::getenv(kVariable)) before_ = before;
    setenv(kVariable, folder.c_str(), 1);
  }
  ~LibraryFolder() {
    if (before_.empty()) {
      unsetenv(kVariable);
    } else {
      setenv(kVariable, before_.c_str(), 1);
    }
  }
  LibraryFolder(const LibraryFolder&) = delete;
  LibraryFolder& operator=(const LibraryFolder&) = delete;

 private:
  static constexpr const char* kVariable = "LD_LIBRARY_PATH";
  std::string before_;
};

class WithoutOsmesa : public testing::Test {
 protected:
  [[nodiscard]] ProgramResult render(const std::filesystem::path& libraries,
                                     const std::string& backend) const {
    const LibraryFolder first(libraries);
    const std::string path = folder_.write("path.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
    return run_program({"render", path, "-o", picture_, "--size", "320x240", "--backend", backend});
  }

  static void expect_error(const ProgramResult& result, const std::string& text) {
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, MatchesRegex("cvo_slam: error: [^\n]+\n"));
    EXPECT_THAT(result.errors, HasSubstr(text));
    EXPECT_THAT(result.errors, HasSubstr("renderer splat"));
  }

  /// Auto falls back to the splatter, says so, and draws.
  void expect_fallback(const ProgramResult& result) const {
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("drawn by splat"));
    const cv::Mat image = cv::imread(picture_);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(image, mean, deviation);
    EXPECT_GT(deviation[0], 3);  // not a picture of nothing
  }

  TemporaryFolder folder_;
  std::string picture_ = folder_.path() / "out.png";
};

TEST_F(WithoutOsmesa, ALibraryThatCannotBeLoadedIsAClearLineOrTheFallback) {
  // A file of that name that is no library is found first, and ends the search.
  folder_.write("broken/libOSMesa.so.8", "no library");
  const auto libraries = folder_.path() / "broken";
  expect_error(render(libraries, "osmesa"), "libOSMesa.so.8 cannot be loaded");
  EXPECT_FALSE(std::filesystem::exists(picture_));
  expect_fallback(render(libraries, "auto"));
}

TEST_F(WithoutOsmesa, ALibraryWithoutAContextIsAClearLineOrTheFallback) {
  expect_error(render(CVO_SLAM_NO_CONTEXT_FOLDER, "osmesa"), "OSMesa gives no context");
  EXPECT_FALSE(std::filesystem::exists(picture_));
  expect_fallback(render(CVO_SLAM_NO_CONTEXT_FOLDER, "auto"));
}

}  // namespace
}  // namespace cvo_slam
