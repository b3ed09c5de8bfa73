// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/options.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

enum class Solver { kFlow, kNewton };

struct Inner {
  double radius = 0.5;
  std::vector<double> scales = {0.1, 0.05};
  std::vector<int> iterations = {40, 20};
};

struct Outer {
  bool verbose = false;
  int count = 3;
  Solver solver = Solver::kNewton;
  Inner inner;
};

OptionSet describe(Inner& o) {
  return OptionSet()
      .add("radius", o.radius, {0, 1}, "m", "A radius.")
      .add("scales", o.scales, {1e-3, 1}, "m", "Scales.")
      .add("iterations", o.iterations, {1, 100}, "", "Iterations at each scale.");
}

OptionSet describe(Outer& o) {
  return OptionSet()
      .add("verbose", o.verbose, "Says more.")
      .add("count", o.count, {.min = 1}, "", "A count.")
      .add("solver", o.solver, {{"flow", Solver::kFlow}, {"newton", Solver::kNewton}}, "Solver.")
      .add("inner", describe(o.inner));
}

std::string error_of(const OptionSet& options, const std::string& key, const std::string& value) {
  try {
    options.set(key, value);
  } catch (const OptionError& error) {
    return error.what();
  }
  return "no error";
}

TEST(OptionSet, SetsAndGetsEveryKind) {
  Outer outer;
  const OptionSet options = describe(outer);
  options.set("verbose", "true");
  options.set("count", " 7 ");
  options.set("solver", "flow");
  options.set("inner.radius", "0.25");
  options.set("inner.scales", "[0.2, 0.1,0.05]");
  options.set("inner.iterations", "[30,10, 5]");
  EXPECT_TRUE(outer.verbose);
  EXPECT_EQ(outer.count, 7);
  EXPECT_EQ(outer.solver, Solver::kFlow);
  EXPECT_EQ(outer.inner.radius, 0.25);
  EXPECT_THAT(outer.inner.scales, testing::ElementsAre(0.2, 0.1, 0.05));
  EXPECT_THAT(outer.inner.iterations, testing::ElementsAre(30, 10, 5));
  for (const char* key :
       {"verbose", "count", "solver", "inner.radius", "inner.scales", "inner.iterations"}) {
    const std::string text = options.get(key);
    options.set(key, text);
    EXPECT_EQ(options.get(key), text);
  }
}

TEST(OptionSet, NamesTheNearestKey) {
  Outer outer;
  EXPECT_EQ(error_of(describe(outer), "inner.radus", "1"),
            "unknown option 'inner.radus'; did you mean 'inner.radius'?");
}

TEST(OptionSet, NamesNoKeyThatIsNotNear) {
  Outer outer;
  EXPECT_EQ(error_of(describe(outer), "foo", "1"), "unknown option 'foo'; see --dump-config");
}

TEST(Suggestion, NamesACandidateThatDiffersInHalfOfTheLettersAtMost) {
  EXPECT_EQ(suggestion("rnu", {"eval", "run"}), "did you mean 'run'?");  // 2 of 3, rounded up
  EXPECT_EQ(suggestion("rgdb", {"rgbd"}), "did you mean 'rgbd'?");       // 2 of 4
  EXPECT_EQ(suggestion("xgdb", {"rgbd"}), "there are: rgbd");            // 3 of 4
  EXPECT_EQ(suggestion("synthesize", {"eval", "run"}), "there are: eval, run");
}

TEST(OptionSet, RejectsBadValuesAndKeepsTheOldOne) {
  Outer outer;
  const OptionSet options = describe(outer);
  EXPECT_EQ(error_of(options, "inner.radius", "2"), "inner.radius=2: the value must be 0 to 1");
  EXPECT_EQ(error_of(options, "count", "0"), "count=0: the value must be at least 1");
  EXPECT_EQ(error_of(options, "solver", "magic"),
            "solver=magic: the value must be one of flow, newton");
  for (const char* bad : {"nan", "", "x", "1e999", "0.5m"}) {
    EXPECT_NE(error_of(options, "inner.radius", bad), "no error") << bad;
  }
  for (const char* bad : {"[]", "0.1", "[0.1", "[0.1,]", "[5]"}) {
    EXPECT_NE(error_of(options, "inner.scales", bad), "no error") << bad;
  }
  for (const char* bad : {"[]", "[0]", "[1, 2.5]", "[1, 101]", "7"}) {
    EXPECT_EQ(error_of(options, "inner.iterations", bad),
              "inner.iterations=" + std::string(bad) +
                  ": the value must be a list [a, b, ...] of values 1 to 100");
  }
  EXPECT_EQ(outer.inner.radius, 0.5);
  EXPECT_EQ(outer.count, 3);
}

TEST(OptionSet, CheckFindsWhatCodeSetWrongly) {
  Outer outer;
  EXPECT_NO_THROW(describe(outer).check());
  outer.inner.radius = std::nan("");
  EXPECT_THROW(describe(outer).check(), OptionError);
  outer = Outer();
  outer.inner.scales.clear();
  EXPECT_THROW(describe(outer).check(), OptionError);
  outer = Outer();
  outer.solver = static_cast<Solver>(9);
  EXPECT_THROW(describe(outer).check(), OptionError);
}

TEST(Options, ExpertsKeysStandApart) {
  struct {
    int plain = 1;
    int deep = 2;
    int nested = 3;
  } o;
  const OptionSet inner = OptionSet()
                              .add("plain", o.plain, {0, 9}, "", "")
                              .expert()
                              .add("deep", o.deep, {0, 9}, "", "");
  const OptionSet all = OptionSet()
                            .add("a", inner)
                            .expert()
                            .add("b", OptionSet().add("nested", o.nested, {0, 9}, "", ""));
  all.set("expert.a.deep", "5");
  all.set("expert.b.nested", "6");
  EXPECT_EQ(o.deep, 5);
  EXPECT_EQ(o.nested, 6);
  EXPECT_EQ(all.get("a.plain"), "1");
  EXPECT_THROW(all.set("a.deep", "1"), OptionError);
}

}  // namespace
}  // namespace cvo_slam
