// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/options_file.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

enum class Solver { kFlow, kNewton };

struct Settings {
  bool verbose = false;
  Solver solver = Solver::kNewton;
  double radius = 0.5;
  std::vector<double> scales = {0.1, 0.05};
  int count = 3;
};

/// The options of a nested map are not next to each other, as where two structs share a prefix.
OptionSet describe(Settings& s) {
  return OptionSet()
      .add("tracker.radius", s.radius, {}, "m", "A radius.\nIn two lines.")
      .add("verbose", s.verbose, "Says more.")
      .add("tracker.solver", s.solver, {{"flow", Solver::kFlow}, {"newton", Solver::kNewton}},
           "A solver.")
      .add("tracker.inner.scales", s.scales, {}, "m", "Scales.")
      .add("count", s.count, {.min = 1}, "", "A count.");
}

std::string read_error(const std::string& text) {
  Settings settings;
  const TemporaryFolder folder;
  const auto file = folder.write("o.yaml", text);
  return input_error(folder.path(), [&] { read_options(file, describe(settings)); });
}

void read_text(const std::string& text, Settings& settings) {
  const TemporaryFolder folder;
  read_options(folder.write("o.yaml", text), describe(settings));
}

TEST(ReadOptions, SetsWhatTheFileNamesAndLeavesTheRest) {
  Settings settings;
  read_text(
      "verbose: true\n"
      "tracker:\n"
      "  solver: flow  # a comment\n"
      "  inner:\n"
      "    scales: [3, 2.5, 1e-3]\n"
      "tracker.radius: 7\n",
      settings);
  EXPECT_TRUE(settings.verbose);
  EXPECT_EQ(settings.solver, Solver::kFlow);
  EXPECT_EQ(settings.radius, 7);
  EXPECT_THAT(settings.scales, ElementsAre(3, 2.5, 1e-3));
  EXPECT_EQ(settings.count, 3);
}

TEST(ReadOptions, AnEmptyFileSetsNothing) {
  EXPECT_EQ(read_error(""), "no error");
  EXPECT_EQ(read_error("# nothing but a comment\n"), "no error");
}

TEST(ReadOptions, NamesTheLineOfAMistake) {
  EXPECT_EQ(read_error("verbose: true\ntracker:\n  radios: 1\n"),
            "o.yaml:3: unknown option 'tracker.radios'; did you mean 'tracker.radius'?");
  EXPECT_EQ(read_error("\ncount: 0\n"), "o.yaml:2: count=0: the value must be at least 1");
  EXPECT_EQ(read_error("count: 1\ncount: 2\n"), "o.yaml:2: key 'count' is given twice; remove one");
  EXPECT_EQ(read_error("tracker:\n  radius: 1\ntracker.radius: 2\n"),
            "o.yaml:3: option 'tracker.radius' is set twice; remove one");
  EXPECT_EQ(read_error("tracker:\n  radius:\n"), "o.yaml:2: tracker.radius: a value is missing");
  EXPECT_EQ(read_error("count: [[1]]\n"), "o.yaml:1: count: expected a word");
  EXPECT_EQ(read_error("tracker.inner.scale:\n  - 3\n"),
            "o.yaml:1: unknown option 'tracker.inner.scale'; did you mean 'tracker.inner.scales'?");
  EXPECT_THAT(read_error("tracker: 5\n"), HasSubstr("o.yaml:1: unknown option 'tracker'"));
  EXPECT_THAT(read_error("just words\n"), HasSubstr("o.yaml:1: expected 'key: value' lines"));
  EXPECT_THAT(read_error("a: b: c\n"), HasSubstr("o.yaml:1: not valid YAML"));
  EXPECT_THAT(read_error("[1, 2]: 3\n"), HasSubstr("o.yaml:1: a key must be a plain word"));
}

TEST(ReadOptions, NamesAFileThatIsMissing) {
  Settings settings;
  EXPECT_THROW(read_options("/nowhere/o.yaml", describe(settings)), InputError);
}

TEST(OptionsToYaml, WritesEachMapOnceInTheOrderOfTheOptions) {
  Settings settings;
  EXPECT_EQ(options_to_yaml(describe(settings)),
            "tracker:\n"
            "  radius: 0.5\n"
            "  solver: newton\n"
            "  inner:\n"
            "    scales: [0.1, 0.05]\n"
            "verbose: false\n"
            "count: 3\n");
}

TEST(OptionsToYaml, CommentsSayWhatUnitAndRange) {
  Settings settings;
  const std::string text = options_to_yaml(describe(settings), true);
  // The line breaks of the documentation are replaced: it is wrapped at 100 characters.
  EXPECT_THAT(text, HasSubstr("  # A radius. In two lines.\n  # [m; any number]\n  radius: 0.5\n"));
  EXPECT_THAT(text, HasSubstr("# A count.\n# [at least 1]\ncount: 3\n"));
}

TEST(OptionsToYaml, LongCommentsAreWrapped) {
  bool value = false;
  std::string doc;
  for (int i = 0; i < 40; ++i) doc += "word" + std::to_string(i) + " ";
  std::istringstream lines(options_to_yaml(OptionSet().add("key", value, doc), true));
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
  EXPECT_LE(longest, 100U);
  EXPECT_GT(longest, 90U);
}

TEST(OptionsToYaml, IsReadBackToTheLastDigit) {
  const bool passed = rc::check("round trip", [](bool verbose, bool flow, double radius, int count,
                                                 const std::vector<double>& scales) {
    RC_PRE(std::isfinite(radius) && count > 0 && !scales.empty());
    Settings written{verbose, flow ? Solver::kFlow : Solver::kNewton, radius, scales, count};
    for (const bool comments : {false, true}) {
      Settings read;
      read_text(options_to_yaml(describe(written), comments), read);
      RC_ASSERT(read.verbose == written.verbose);
      RC_ASSERT(read.solver == written.solver);
      RC_ASSERT(read.radius == written.radius);
      RC_ASSERT(read.scales == written.scales);
      RC_ASSERT(read.count == written.count);
    }
  });
  EXPECT_TRUE(passed);
}

}  // namespace
}  // namespace cvo_slam
