// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// That the rules bite: each on a snippet that breaks it and on one that only looks as if it did.
#include "cvo_slam/tests/architecture/rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/tests/architecture/rooms.h"

namespace cvo_slam::architecture {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

Findings check(Rule rule, const std::string& path, std::string_view text) {
  return rule(SourceFile(path, text));
}

/// One finding for each snippet, as the only line of a file.
void expect_bites(Rule rule, const std::string& path, const std::vector<std::string>& snippets) {
  for (const std::string& snippet : snippets) {
    EXPECT_THAT(check(rule, path, snippet), ElementsAre(StartsWith(path + ":1: "))) << snippet;
  }
}

void expect_passes(Rule rule, const std::string& path, const std::vector<std::string>& snippets) {
  for (const std::string& snippet : snippets) {
    EXPECT_THAT(check(rule, path, snippet), IsEmpty()) << snippet;
  }
}

TEST(Views, TellCommentsAndLiteralsFromCode) {
  const Views views =
      split_views("a(\"x // y\", 'c'); // b \"d\"\n/* e\nf */ g 1'000", Language::kCpp);
  EXPECT_EQ(views.code, "a(        ,    );         \n    \n     g 1'000");
  EXPECT_EQ(views.strings, "  \"x // y\"  'c'           \n    \n            ");
  EXPECT_EQ(views.comments, "                  // b \"d\"\n/* e\nf */        ");
}

TEST(Views, KnowEscapesAndRawStrings) {
  EXPECT_EQ(split_views(R"__(f("\"x", R"(")", y))__", Language::kCpp).code,
            R"__(f(     , R     , y))__");
  EXPECT_EQ(split_views("R\"a()\")a\" b", Language::kCpp).code, "R         b");
}

TEST(Views, KnowTheCommentsOfScripts) {
  const Views views = split_views("set(X \"# no\") # yes\nA=$#", Language::kScript);
  EXPECT_EQ(views.code, "set(X \"# no\")      \nA=$#");
  EXPECT_EQ(views.comments, "              # yes\n    ");
}

TEST(Rooms, AFileBelongsToItsFolder) {
  EXPECT_EQ(room_of("io/dataset.h")->name, "io");
  EXPECT_EQ(room_of("render/map_scene.h")->name, "render");
  EXPECT_EQ(room_of("iodine/dataset.h"), nullptr);
  EXPECT_EQ(room_of("main.cc"), nullptr);
}

TEST(Rules, IncludesAreSpelledFromTheRoot) {
  expect_bites(includes_are_spelled_from_the_root, "io/a.cc",
               {"#include \"dataset.h\"", "#include \"core/se3.h\"", "#include \"../core/se3.h\"",
                "#include <cvo_slam/core/se3.h>", "  # include \"se3.h\""});
  expect_passes(includes_are_spelled_from_the_root, "io/a.cc",
                {"#include \"cvo_slam/core/se3.h\"", "#include <vector>", "// #include \"a.h\""});
}

TEST(Rules, IncludesFollowTheTable) {
  expect_bites(includes_follow_the_table, "core/a.h",
               {"#include \"cvo_slam/io/dataset.h\"", "#include \"cvo_slam/attic/a.h\""});
  expect_bites(includes_follow_the_table, "frontend/a.h", {"#include \"cvo_slam/io/dataset.h\""});
  expect_bites(includes_follow_the_table, "io/a.h", {"#include \"cvo_slam/render/map_scene.h\""});
  expect_bites(includes_follow_the_table, "slam/a.h", {"#include \"cvo_slam/io/dataset.h\""});
  expect_bites(includes_follow_the_table, "apps/a.cc", {"#include \"cvo_slam/tests/a.h\""});
  expect_passes(includes_follow_the_table, "core/a.cc", {"#include \"cvo_slam/core/se3.h\""});
  expect_passes(includes_follow_the_table, "render/a.cc",
                {"#include \"cvo_slam/io/dataset.h\"", "#include \"cvo_slam/render/b.h\""});
  expect_passes(includes_follow_the_table, "apps/a.cc", {"#include \"cvo_slam/io/dataset.h\""});
}

TEST(Rules, InternalHeadersStayInside) {
  const std::string include = "#include \"cvo_slam/io/text_internal.h\"";
  expect_bites(public_headers_include_no_internal_ones, "io/a.h", {include});
  expect_passes(public_headers_include_no_internal_ones, "io/a.cc", {include});
  expect_passes(public_headers_include_no_internal_ones, "io/b_internal.h", {include});
  expect_bites(internal_headers_stay_in_their_room, "apps/a.cc", {include});
  expect_bites(internal_headers_stay_in_their_room, "synthetic/a.cc", {include});
  expect_passes(internal_headers_stay_in_their_room, "io/a.cc", {include});
  expect_passes(internal_headers_stay_in_their_room, "tests/io/a_test.cc", {include});
}

TEST(Rules, SourcesLiveInARoom) {
  expect_bites(sources_live_in_a_room, "attic/a.cc", {"int x;"});
  expect_bites(sources_live_in_a_room, "main.cc", {"int x;"});
  expect_passes(sources_live_in_a_room, "tools/a.sh", {"x=1"});
}

TEST(Rules, LibrariesDoNotPrint) {
  const std::vector<std::string> prints = {
      "std::cout << 1;",     "cerr << 1;",          "std::clog << 1;", "printf(\"\");",
      "std::fprintf(f, x);", "puts(\"\");",         "putchar(c);",     "perror(\"\");",
      "fmt::print(\"\");",   "#include <iostream>", "fflush(stdout);"};
  expect_bites(libraries_do_not_print, "core/a.cc", prints);
  expect_passes(libraries_do_not_print, "apps/a.cc", prints);
  expect_passes(libraries_do_not_print, "core/a.cc",
                {"// std::cout", "x = \"printf(\";", "std::snprintf(b, n, x);", "blueprint(x);",
                 "fmt::format(\"\");", "file << x;", "print_options(x);"});
}

TEST(Rules, LibrariesDoNotEndTheProgram) {
  expect_bites(libraries_do_not_end_the_program, "core/a.cc",
               {"exit(1);", "std::exit(1);", "x ? abort() : f();", "std::quick_exit(0);",
                "_exit(2);", "std::terminate();"});
  expect_passes(libraries_do_not_end_the_program, "core/a.cc",
                {"app.exit(error);", "p->abort();", "on_exit(f);", "// exit(1)", "exit_code(1);"});
}

TEST(Rules, LibrariesDoNotSleep) {
  expect_bites(libraries_do_not_sleep, "io/a.cc",
               {"std::this_thread::sleep_for(1s);", "usleep(1);", "sleep(1);", "nanosleep(a, b);"});
  expect_passes(libraries_do_not_sleep, "io/a.cc", {"asleep(1);", "// sleep(1)"});
}

TEST(Rules, LibrariesSetNothingProcessWide) {
  expect_bites(libraries_set_nothing_process_wide, "io/a.cc",
               {"cv::setNumThreads(1);", "std::locale::global(l);", "srand(1);", "x = rand();",
                "tbb::global_control c(1, 2);"});
  expect_passes(libraries_set_nothing_process_wide, "io/a.cc", {"operand(1);", "x.random();"});
}

TEST(Rules, ThreadsBelongToTheScheduler) {
  const std::vector<std::string> threads = {"std::thread t;", "std::mutex m;", "std::jthread t;",
                                            "std::async(f);", "std::condition_variable c;"};
  expect_bites(threads_belong_to_the_scheduler, "frontend/a.cc", threads);
  expect_passes(threads_belong_to_the_scheduler, "slam/a.cc", threads);
  expect_passes(threads_belong_to_the_scheduler, "core/a.cc", {"int threads = 1;"});
}

TEST(Rules, MemoryHasOwners) {
  expect_bites(memory_has_owners, "apps/a.cc",
               {"auto* p = new int;", "new (p) T();", "delete p;", "delete[] p;", "f(new T);",
                "std::malloc(1);", "free(p);"});
  expect_passes(memory_has_owners, "apps/a.cc",
                {"A(const A&) = delete;", "A(A&&) =delete;", "int new_size;", "// a new one",
                 "#include <new>", "lock.free(x);", "std::make_unique<int>(1);"});
  const std::string counter = "void* operator new(std::size_t n) {\n std::malloc(n);\n}";
  EXPECT_THAT(check(memory_has_owners, "tests/a.cc", counter), IsEmpty());
  EXPECT_THAT(check(memory_has_owners, "core/a.cc", counter), Not(IsEmpty()));
}

TEST(Rules, HeadersOpenNoNamespaces) {
  expect_bites(headers_open_no_namespaces, "core/a.h", {"using namespace std;"});
  expect_passes(headers_open_no_namespaces, "core/a.cc", {"using namespace std;"});
  expect_passes(headers_open_no_namespaces, "core/a.h", {"using std::swap;"});
}

TEST(Rules, HeadersAreIncludedOnce) {
  expect_bites(headers_are_included_once, "core/a.h", {"int x;", "// #pragma once"});
  expect_passes(headers_are_included_once, "core/a.h", {"#pragma once"});
  expect_passes(headers_are_included_once, "core/a.h",
                {"#if defined(A_H) == defined(HWY_TARGET_TOGGLE)"});
  expect_passes(headers_are_included_once, "core/a.cc", {"int x;"});
}

TEST(Rules, LicencesAreStated) {
  const std::string copyright = "SPDX-FileCopyrightText: 2026 The cvo_slam authors\n";
  const std::string licence = "SPDX-License-Identifier: BSD-3-Clause\n";
  expect_bites(licences_are_stated, "core/a.h", {"int x;", "// " + copyright, "// " + licence});
  expect_bites(licences_are_stated, "core/a.h", {"\n\n\n// " + copyright + "// " + licence});
  expect_passes(licences_are_stated, "core/a.h", {"// " + copyright + "// " + licence});
  expect_passes(licences_are_stated, "tools/a.sh", {"#!/bin/sh\n# " + copyright + "# " + licence});
}

TEST(Rules, FilesAreShort) {
  std::string text;
  for (int line = 0; line < 400; ++line) text += "int x;\n";
  EXPECT_THAT(check(files_are_short, "core/a.cc", text), IsEmpty());
  EXPECT_THAT(check(files_are_short, "core/a.cc", text + "int y;\n"),
              ElementsAre(StartsWith("core/a.cc:401: 401 lines")));
}

TEST(Rules, NothingIsLeftToDo) {
  expect_bites(nothing_is_left_to_do, "core/a.cc", {"// TODO: x", "/* FIXME */", "f();  // XXX"});
  expect_bites(nothing_is_left_to_do, "cmake/a.cmake", {"# TODO"});
  expect_passes(nothing_is_left_to_do, "core/a.cc", {"f(\"TODO\");", "// TODOS", "int TODO;"});
}

TEST(Rules, BuildsArePortable) {
  for (const std::string path : {"CMakeLists.txt", "cmake/a.cmake", "CMakePresets.json"}) {
    expect_bites(builds_are_portable, path,
                 {"target_compile_options(a PRIVATE -ffast-math)",
                  "set(CMAKE_CXX_FLAGS \"-march=native\")", "add(-mavx2)", "add(-Ofast)"});
  }
  expect_passes(builds_are_portable, "CMakeLists.txt",
                {"# no -march=native", "add(-ffp-contract=off)", "add(-Wall -mno-omit)"});
}

TEST(Rules, FindingsNameTheLine) {
  EXPECT_THAT(check(libraries_do_not_print, "core/a.cc", "int x;\n\nputs(\"\");\nputs(\"\");\n"),
              ElementsAre(StartsWith("core/a.cc:3: 'puts('"), StartsWith("core/a.cc:4: ")));
  EXPECT_THAT(check(includes_follow_the_table, "core/a.h",
                    "/*\n#include \"cvo_slam/io/a.h\"\n*/\n#include \"cvo_slam/io/a.h\"\n"),
              ElementsAre(StartsWith("core/a.h:4: include 'cvo_slam/io/a.h'")));
  EXPECT_THAT(check(memory_has_owners, "core/a.cc", ""), SizeIs(0));
}

}  // namespace
}  // namespace cvo_slam::architecture
