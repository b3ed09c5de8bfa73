// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The manual has no broken links: every relative link of a page leads to a file, and to a heading
// of it where the link names one; every page that a source file or a script names exists. Pages of
// results are only made from a tree without changes.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "cvo_slam/tests/architecture/rules.h"
#include "cvo_slam/tests/architecture/source_file.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam::architecture {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return split_lines(std::string(std::istreambuf_iterator<char>(stream), {}));
}

/// The lines of a page, those of code blocks blank: what they hold is neither link nor heading.
std::vector<std::string> prose_of(const fs::path& page) {
  std::vector<std::string> lines = lines_of(page);
  bool in_code = false;
  for (std::string& line : lines) {
    const bool fence = line.find("```") != std::string::npos;
    if (fence) in_code = !in_code;
    if (fence || in_code) line.clear();
  }
  return lines;
}

/// The name by which a link finds a heading: lower case, blanks as hyphens, without punctuation.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || c == '-' || c == '_') {
      anchor += static_cast<char>(std::tolower(byte));
    } else if (c == ' ') {
      anchor += '-';
    }
  }
  return anchor;
}

bool has_heading(const fs::path& page, const std::string& anchor) {
  static const std::regex kHeading("^#+ +(.*)$");
  const auto lines = prose_of(page);
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    std::smatch match;
    return std::regex_match(line, match, kHeading) && anchor_of(match[1]) == anchor;
  });
}

/// What is wrong with the target of a link of `page`; empty if nothing is, or if it leads elsewhere
/// than into the project.
std::string fault_of_link(const fs::path& page, const std::string& target) {
  if (target.find("://") != std::string::npos || target.starts_with("mailto:")) return "";
  const std::size_t hash = target.find('#');
  const std::string path = target.substr(0, hash);
  const fs::path file = path.empty() ? page : page.parent_path() / path;
  if (!fs::exists(file)) return "no such file";
  if (hash == std::string::npos || fs::is_directory(file)) return "";
  return has_heading(file, target.substr(hash + 1)) ? "" : "no such heading";
}

/// A line for each broken link of a page: file, line, link, what is wrong.
Findings broken_links(const fs::path& page) {
  static const std::regex kLink(R"(\]\(([^)\s]+)\))");
  Findings findings;
  const auto lines = prose_of(page);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (auto it = std::sregex_iterator(lines[i].begin(), lines[i].end(), kLink);
         it != std::sregex_iterator(); ++it) {
      const std::string fault = fault_of_link(page, (*it)[1]);
      if (fault.empty()) continue;
      findings.push_back(fmt::format("{}:{}: {}: {}", page.string(), i + 1, it->str(1), fault));
    }
  }
  return findings;
}

/// Every page of the project; build trees and the repository's own folder are left out.
std::vector<fs::path> pages() {
  const fs::path root = CVO_SLAM_SOURCE_DIR;
  std::vector<fs::path> result;
  for (const char* folder : {"docs", "config"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() == ".md") result.push_back(entry.path());
    }
  }
  for (const char* page : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"}) {
    result.push_back(root / page);
  }
  return result;
}

TEST(Manual, LinksLeadSomewhere) {
  for (const fs::path& page : pages()) {
    for (const std::string& finding : broken_links(page)) ADD_FAILURE() << finding;
  }
}

TEST(Manual, PagesThatTheSourcesNameExist) {
  static const std::regex kPage(R"(docs/[a-z0-9/_-]+\.md)");
  for (const SourceFile& file : read_tree(CVO_SLAM_SOURCE_DIR)) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_search(file.lines[i], match, kPage)) continue;
      EXPECT_TRUE(fs::exists(fs::path(CVO_SLAM_SOURCE_DIR) / match.str()))
          << file.path << ":" << i + 1 << ": " << match.str();
    }
  }
}

std::string text_of(const fs::path& file) {
  return fmt::format("{}\n", fmt::join(lines_of(file), "\n"));
}

TEST(Manual, TheReadmeShowsTheExamplesAsTheyAre) {
  const fs::path root = CVO_SLAM_SOURCE_DIR;
  const auto code_from = [&](const char* file, const char* begin) {
    const std::string example = text_of(root / "apps" / "examples" / file);
    return "```cpp\n" + example.substr(example.find(begin)) + "```\n";
  };
  const std::string readme = text_of(root / "README.md");
  EXPECT_THAT(readme, testing::HasSubstr(code_from("own_images.cc", "int main()")));
  EXPECT_THAT(readme, testing::HasSubstr(code_from("track_sequence.cc", "#include")));
}

TEST(Manual, TheTestsThatTheErrataNameExist) {
  const fs::path root = CVO_SLAM_SOURCE_DIR;
  std::string tests;
  for (const auto& entry : fs::directory_iterator(root / "tests" / "frontend")) {
    tests += text_of(entry.path());
  }
  static const std::regex kTest("`([A-Z][A-Za-z]{5,})(?:\\.([A-Z][A-Za-z]+|\\*))?`");
  const std::string page = text_of(root / "docs" / "theory" / "cvo.md");
  std::size_t names = 0;
  for (auto it = std::sregex_iterator(page.begin(), page.end(), kTest);
       it != std::sregex_iterator(); ++it) {
    ++names;
    EXPECT_THAT(tests, testing::HasSubstr(it->str(1))) << "docs/theory/cvo.md: " << it->str();
    if (it->str(2) != "*") {
      EXPECT_THAT(tests, testing::HasSubstr(it->str(2))) << "docs/theory/cvo.md: " << it->str();
    }
  }
  EXPECT_GT(names, 10U);
}

TEST(Manual, ABrokenLinkIsFound) {
  const TemporaryFolder folder;
  const fs::path page = folder.path() / "page.md";
  std::ofstream(page) << "# A `b` page: c, d\n"
                      << "[good](page.md) [good](#a-b-page-c-d) [good](https://example.org/x)\n"
                      << "[bad](other.md)\n"
                      << "```\n[code](other.md)\n```\n"
                      << "![bad](images/no.png) [bad](page.md#e)\n";
  using testing::EndsWith;
  EXPECT_THAT(broken_links(page),
              testing::ElementsAre(EndsWith("page.md:3: other.md: no such file"),
                                   EndsWith("page.md:7: images/no.png: no such file"),
                                   EndsWith("page.md:7: page.md#e: no such heading")));
}

/// Exit code of a shell command that runs in a folder.
int run_in(const fs::path& folder, const std::string& command) {
  const std::string line =
      fmt::format("cd '{}' && ( {} ) > /dev/null 2>&1", folder.string(), command);
  return WEXITSTATUS(std::system(line.c_str()));
}

TEST(Results, ATreeWithChangesIsRefused) {
  const TemporaryFolder folder;
  const fs::path& root = folder.path();
  fs::create_directories(root / "docs" / "results");
  fs::copy_file(fs::path(CVO_SLAM_SOURCE_DIR) / "bench" / "results_page.sh", root / "page.sh");
  const std::string script = "unset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE; . ./page.sh";
  EXPECT_EQ(run_in(root, script), 2) << "there is no revision outside of a checkout";

  const std::string commit =
      "unset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE; git init && git add . && git -c user.name=a "
      "-c user.email=a@example.org -c core.hooksPath=/dev/null commit -m a";
  if (run_in(root, commit) != 0) GTEST_SKIP() << "git is not installed";
  EXPECT_EQ(run_in(root, script), 0);
  std::ofstream(root / "docs" / "results" / "page.md") << "a page that is written again\n";
  EXPECT_EQ(run_in(root, script), 0);
  std::ofstream(root / "source.cc") << "a change\n";
  EXPECT_EQ(run_in(root, script), 2);
}

}  // namespace
}  // namespace cvo_slam::architecture
