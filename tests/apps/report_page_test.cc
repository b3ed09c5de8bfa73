// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// report.html of `cvo_slam run`, from outside and, where there is a Chromium, in a browser.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/tests/apps/room_sequence.h"
#include "cvo_slam/tests/apps/run_program.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

constexpr std::size_t kFrames = 12;

/// Every frame becomes a keyframe, and only place recognition adds edges.
const std::vector<std::string> kSlam = {"--mode", "slam",
                                        "--set",  "tracker.keyframe.max_translation=0.01",
                                        "--set",  "tracker.keyframe.max_rotation=0.01",
                                        "--set",  "loops.detection.candidates.min_gap=3",
                                        "--set",  "proximity.near=0",
                                        "--set",  "proximity.recent=0"};

class ReportPage : public testing::Test {
 protected:
  [[nodiscard]] int run(const std::vector<std::string>& options,
                        const std::string& out = "out") const {
    std::vector<std::string> arguments = {"run", sequence_, "--quiet", "--out",
                                          folder_.path() / out};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments).exit_code;
  }

  [[nodiscard]] std::filesystem::path file(const std::string& out = "out") const {
    return folder_.path() / out / "report.html";
  }
  [[nodiscard]] std::string page(const std::string& out = "out") const {
    return read_text(file(out));
  }

  static std::size_t count(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1)) ++n;
    return n;
  }

  static std::string without_section(const std::string& page, const std::string& id) {
    const std::size_t begin = page.find("<section id=\"" + id + "\">");
    const std::size_t end = page.find("</section>", begin);
    return page.substr(0, begin) + page.substr(end);
  }

  RoomSequence room_{kFrames};
  const TemporaryFolder& folder_ = room_.folder();
  const std::filesystem::path sequence_ = room_.path();
};

TEST_F(ReportPage, ShowsFiguresPlotsMapOptionsAndFiles) {
  ASSERT_EQ(run({"--mode", "odometry", "--set", "tracker.points=900"}), 0);
  const std::string html = page();
  EXPECT_THAT(html, StartsWith("<!DOCTYPE html>\n<html lang=\"en\">"));
  for (const char* part :
       {"<h1>room</h1>", "TUM RGB-D · mode odometry · frames 0 to 11", "12 of 12 frames",
        "<dt>ATE</dt>", "<td>RPE 1 frame</td>", "alt=\"The map with the camera&#39;s path\"",
        "Top</text>", "ATE translation, RMSE", "Overlap with the keyframe", "No frame was lost.",
        "<h2>Time and memory</h2>", "2 options are not the default:",
        R"(<td class="code">loops.enabled</td><td class="code">false</td>)",
        R"(<td class="code">tracker.points</td><td class="code">900</td>)", "href=\"frames.csv\"",
        "href=\"map.ply\"", "no RPE 1 s"}) {
    EXPECT_THAT(html, HasSubstr(part));
  }
  EXPECT_THAT(html, Not(HasSubstr("<h2>Graph</h2>")));
  EXPECT_EQ(count(html, "<svg"), 3U);
  EXPECT_EQ(count(html, "<img"), 1U);
  EXPECT_LT(html.size(), 1'000'000U);
}

TEST_F(ReportPage, NeedsNothingButItself) {
  ASSERT_EQ(run(kSlam), 0);
  const std::string html = page();
  const std::regex outside(
      R"~(<script|@import|url\(|src="(?!data:)|href="(https?:|//)|<iframe| on\w+=")~");
  EXPECT_FALSE(std::regex_search(html, outside));
  // The target of every link exists.
  const std::regex link("<a href=\"([^\"]+)\"");
  for (std::sregex_iterator i(html.begin(), html.end(), link), end; i != end; ++i) {
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / i->str(1))) << i->str(1);
  }
}

TEST_F(ReportPage, ShowsTheLoopsWithTheirImages) {
  ASSERT_EQ(run(kSlam), 0);
  const std::string html = page();
  const std::filesystem::directory_iterator entries(folder_.path() / "out" / "loops");
  const auto loops = static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
  ASSERT_GT(loops, 0U);
  EXPECT_EQ(count(html, "with their inlier matches\""), loops);
  EXPECT_EQ(count(html, "Accepted: CVO overlap"), loops);
  EXPECT_THAT(html, HasSubstr(fmt::format("{} from recognised places (bow).", loops)));
  EXPECT_THAT(html, HasSubstr(fmt::format("<td>bow</td><td class=\"number\">{0}</td>", loops)));

  std::vector<std::string> options = kSlam;
  options.insert(options.end(), {"--loop-pictures", "none"});
  ASSERT_EQ(run(options), 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out" / "loops")) << "of the run before";
  EXPECT_THAT(page(), HasSubstr("Pictures of loops were not asked for."));
}

TEST_F(ReportPage, TellsWhyCandidatesWereRejected) {
  std::vector<std::string> options = kSlam;
  options.insert(options.end(), {"--loop-pictures", "all", "--set", "loops.pair.min_overlap=0.99"});
  ASSERT_EQ(run(options), 0);
  EXPECT_THAT(page(), AllOf(HasSubstr("<h3>Rejected</h3>"), HasSubstr("Rejected: overlap 0."),
                            HasSubstr("<td>overlap … is below …</td>")));
}

TEST_F(ReportPage, IsTheSameAgainButForTimes) {
  for (const char* out : {"first", "again"}) ASSERT_EQ(run(kSlam, out), 0);
  EXPECT_EQ(without_section(page("again"), "cost"), without_section(page("first"), "cost"));
  std::vector<std::string> options = kSlam;
  options.insert(options.end(), {"--threads", "2", "--set", "schedule=pipelined"});
  ASSERT_EQ(run(options, "threads"), 0);
  const auto results = [&](const char* out) {  // the number of threads is an option
    return without_section(without_section(page(out), "cost"), "options");
  };
  EXPECT_EQ(results("threads"), results("first"));
  std::size_t pictures = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(folder_.path() / "first" / "loops")) {
    const auto other = folder_.path() / "threads" / "loops" / entry.path().filename();
    EXPECT_EQ(read_text(other), read_text(entry.path())) << other;
    ++pictures;
  }
  EXPECT_GT(pictures, 0U);
}

TEST_F(ReportPage, TellsWhenAndWhyFramesWereLost) {
  room_.blank(5, 6);
  EXPECT_EQ(run({}), 3);
  EXPECT_THAT(page(), HasSubstr("<td>5 to 6</td><td>1000.166667</td><td class=\"number\">2</td>"
                                "<td>only 0 points"));
  EXPECT_THAT(page(), AllOf(HasSubstr("10 of 12 frames"), HasSubstr("class=\"bad\"")));
}

TEST_F(ReportPage, OfARunThatNeverTrackedIsWhole) {
  room_.blank(0, kFrames - 1);
  EXPECT_EQ(run({"--mode", "slam"}), 3);
  EXPECT_THAT(page(),
              AllOf(HasSubstr("0 of 12 frames"), HasSubstr("<td>0 to 11</td>"),
                    HasSubstr("No picture of the map"), HasSubstr("No loop was closed. The option"),
                    HasSubstr("no errors: "), HasSubstr("</html>")));
  EXPECT_THAT(page(), Not(HasSubstr("nan")));
}

TEST_F(ReportPage, WithoutGroundTruthHasNoErrors) {
  std::filesystem::remove(sequence_ / "groundtruth.txt");
  ASSERT_EQ(run({"--no-map"}), 0);
  EXPECT_THAT(page(), AllOf(HasSubstr("no errors: the sequence has no ground truth"),
                            HasSubstr("No picture of the map"), HasSubstr("Top</text>"),
                            Not(HasSubstr("<h2>Accuracy</h2>")), Not(HasSubstr("<dt>ATE"))));
}

TEST_F(ReportPage, EscapesTheNamesOfFiles) {
  const auto hostile = folder_.path() / "<b onclick='x'>&\"room\"";
  std::filesystem::rename(sequence_, hostile);
  const auto result =
      run_program({"run", hostile, "--quiet", "--out", folder_.path() / "out", "--frames", "0:3"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(page(),
              AllOf(HasSubstr("<h1>&lt;b onclick=&#39;x&#39;&gt;&amp;&quot;room&quot;</h1>"),
                    Not(HasSubstr("<b onclick"))));
}

TEST_F(ReportPage, ThatCannotBeWrittenIsAnErrorAfterTheFigures) {
  folder_.write("out/report.html/file", "in the way");
  const auto result =
      run_program({"run", sequence_, "--out", folder_.path() / "out", "--overwrite"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("report.html: cannot be written"));
  EXPECT_THAT(result.output, HasSubstr("ATE"));
}

/// Returns the name of the browser, or nothing if there is none.
std::optional<std::string> find_chromium() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    if (std::system(fmt::format("command -v {} >/dev/null", name).c_str()) == 0) return name;
  }
  return std::nullopt;
}

class ReportInABrowser : public ReportPage {
 protected:
  void SetUp() override {
    browser_ = find_chromium();
    if (!browser_)
      GTEST_SKIP() << "no chromium on this machine; on Debian: apt-get install chromium";
  }

  /// Opens a page and returns the log of the browser. The option says what to make of the page.
  [[nodiscard]] std::string open(const std::filesystem::path& html,
                                 const std::string& option) const {
    const auto log = folder_.path() / "browser.log";
    const std::string command = fmt::format(
        "timeout 60 {} --headless=new --no-sandbox --disable-gpu --disable-dev-shm-usage "
        "--hide-scrollbars --user-data-dir='{}' --enable-logging=stderr --v=0 {} 'file://{}' "
        ">'{}' 2>&1",
        *browser_, (folder_.path() / "profile").string(), option, html.string(), log.string());
    EXPECT_EQ(std::system(command.c_str()), 0) << read_text(log);
    return read_text(log);
  }

  [[nodiscard]] cv::Mat screenshot(const std::filesystem::path& html, int width) const {
    const auto png = folder_.path() / "screenshot.png";
    const std::string log =
        open(html, fmt::format("--window-size={},1800 --screenshot='{}'", width, png.string()));
    EXPECT_THAT(log, Not(HasSubstr("CONSOLE")));
    return cv::imread(png);
  }

  std::optional<std::string> browser_;
};

// Without this test an empty log in the others would prove nothing.
TEST_F(ReportInABrowser, AnErrorOnTheConsoleWouldBeSeen) {
  const auto bad = folder_.write("bad.html", "<!DOCTYPE html><script>nonsense()</script>");
  const auto png = folder_.path() / "bad.png";
  EXPECT_THAT(open(bad, fmt::format("--screenshot='{}'", png.string())), HasSubstr("CONSOLE"));
}

TEST_F(ReportInABrowser, IsDrawnWithoutAnErrorOnWideAndNarrowScreens) {
  ASSERT_EQ(run(kSlam), 0);
  for (const int width : {1280, 600}) {
    const cv::Mat picture = screenshot(file(), width);
    ASSERT_EQ(picture.size(), cv::Size(width, 1800));
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(picture, mean, deviation);
    EXPECT_GT(mean[0], 128) << "a light page";
    EXPECT_GT(deviation[0], 10) << "text, and a map in colours, on it";
    // The map has colours and the page around it none.
    std::vector<cv::Mat> channels;
    cv::split(picture, channels);
    EXPECT_GT(cv::countNonZero(cv::abs(channels[0] - channels[2]) > 40), 10'000);
  }
}

TEST_F(ReportInABrowser, PrintsOnPaper) {
  ASSERT_EQ(run({}), 0);
  const auto pdf = folder_.path() / "report.pdf";
  const std::string log = open(file(), fmt::format("--print-to-pdf='{}'", pdf.string()));
  EXPECT_THAT(log, Not(HasSubstr("CONSOLE")));
  EXPECT_THAT(read_text(pdf), StartsWith("%PDF"));
  EXPECT_GT(std::filesystem::file_size(pdf), 50'000U) << "with the picture of the map";
}

}  // namespace
}  // namespace cvo_slam
