// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rules of docs/architecture.md, on every file of the project.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/tests/architecture/rooms.h"
#include "cvo_slam/tests/architecture/rules.h"

namespace cvo_slam::architecture {
namespace {

const std::vector<SourceFile>& tree() {
  static const std::vector<SourceFile> files = read_tree(CVO_SLAM_SOURCE_DIR);
  return files;
}

void expect_no_finding(Rule rule) {
  for (const SourceFile& file : tree()) {
    for (const std::string& finding : rule(file)) ADD_FAILURE() << finding;
  }
}

TEST(Architecture, TheWalkFindsTheProject) {
  std::vector<std::string> paths;
  for (const SourceFile& file : tree()) paths.push_back(file.path);
  EXPECT_THAT(paths, testing::IsSupersetOf({".ci/run", "CMakeLists.txt", "CMakePresets.json",
                                            "Makefile", "apps/main.cc", "core/se3.h",
                                            "cmake/Room.cmake", "tests/architecture/tree_test.cc",
                                            "tools/install_packages.sh"}));
  EXPECT_THAT(paths, testing::Not(testing::Contains(testing::StartsWith("build/"))));
}

TEST(Architecture, IncludesAreSpelledFromTheRoot) {
  expect_no_finding(includes_are_spelled_from_the_root);
}
TEST(Architecture, IncludesFollowTheTable) { expect_no_finding(includes_follow_the_table); }
TEST(Architecture, PublicHeadersIncludeNoInternalOnes) {
  expect_no_finding(public_headers_include_no_internal_ones);
}
TEST(Architecture, InternalHeadersStayInTheirRoom) {
  expect_no_finding(internal_headers_stay_in_their_room);
}
TEST(Architecture, SourcesLiveInARoom) { expect_no_finding(sources_live_in_a_room); }
TEST(Architecture, LibrariesDoNotPrint) { expect_no_finding(libraries_do_not_print); }
TEST(Architecture, LibrariesDoNotEndTheProgram) {
  expect_no_finding(libraries_do_not_end_the_program);
}
TEST(Architecture, LibrariesDoNotSleep) { expect_no_finding(libraries_do_not_sleep); }
TEST(Architecture, LibrariesSetNothingProcessWide) {
  expect_no_finding(libraries_set_nothing_process_wide);
}
TEST(Architecture, ThreadsBelongToTheScheduler) {
  expect_no_finding(threads_belong_to_the_scheduler);
}
TEST(Architecture, MemoryHasOwners) { expect_no_finding(memory_has_owners); }
TEST(Architecture, HeadersOpenNoNamespaces) { expect_no_finding(headers_open_no_namespaces); }
TEST(Architecture, HeadersAreIncludedOnce) { expect_no_finding(headers_are_included_once); }
TEST(Architecture, LicencesAreStated) { expect_no_finding(licences_are_stated); }
TEST(Architecture, FilesAreShort) { expect_no_finding(files_are_short); }
TEST(Architecture, NothingIsLeftToDo) { expect_no_finding(nothing_is_left_to_do); }
TEST(Architecture, BuildsArePortable) { expect_no_finding(builds_are_portable); }

/// The last column of the manual's table, "core, io" or "all libraries, apps".
std::string documented_row(const Room& room) {
  if (room.may_include.empty()) return "nothing of the project";
  if (room.is_library) return fmt::format("{}", fmt::join(room.may_include, ", "));
  std::string text = "all libraries";
  for (const std::string_view name : room.may_include) {
    const bool library = room_of(fmt::format("{}/any.h", name))->is_library;
    if (!library) text += fmt::format(", {}", name);
  }
  return text;
}

/// Returns the names of the functions and constants that a file defines for itself alone, each at
/// the beginning of a line.
std::set<std::string> private_names(const SourceFile& file) {
  static const std::regex kFunction(R"(^[A-Za-z_][\w:<>,&* ]*[ &*](\w+)\(.*)");
  static const std::regex kConstant(R"(^(?:constexpr|const)\s[^(){};=]*\b(k[A-Z]\w*)\b.*)");
  std::set<std::string> names;
  bool inside = false;
  for (std::size_t i = 0; i < file.code.size(); ++i) {
    const std::string& line = file.code[i];
    if (line.starts_with("namespace {")) inside = true;
    if (file.lines[i].starts_with("}  // namespace")) inside = false;
    std::smatch match;
    if (inside && line.size() < 200 &&
        (std::regex_match(line, match, kFunction) || std::regex_match(line, match, kConstant))) {
      names.insert(match[1]);
    }
  }
  return names;
}

/// Returns the classes that a header defines, with their namespace.
std::set<std::string> classes_of_namespace(const SourceFile& header) {
  static const std::regex kClass(R"(^(?:struct|class|enum class) ((?:\w+::)*\w+)\b[^;]*)");
  static const std::regex kNamespace(R"(^namespace ([\w:]+) \{.*)");
  std::set<std::string> names;
  std::string space;
  for (const std::string& line : header.code) {
    std::smatch match;
    if (std::regex_match(line, match, kNamespace)) space = match[1];
    if (std::regex_match(line, match, kClass)) names.insert(space + "::" + match[1].str());
  }
  return names;
}

// Two classes of one name in one namespace are one to the linker, in whatever libraries they are:
// the program then calls the constructor of one for the other.
TEST(Architecture, ClassesOfHeadersHaveOneDefinition) {
  std::map<std::string, std::string> owner;
  for (const SourceFile& file : tree()) {
    if (!file.path.ends_with(".h") || room_of(file.path) == nullptr) continue;
    for (const std::string& name : classes_of_namespace(file)) {
      const auto [entry, is_new] = owner.emplace(name, file.path);
      EXPECT_TRUE(is_new) << file.path << ": '" << name << "' is also in " << entry->second
                          << "; give one of them another name";
    }
  }
  EXPECT_GT(owner.size(), 200U) << "the files must be understood";
}

// In a unity build the sources of a room are one: a name of one file would hide that of another,
// or be called in its place.
TEST(Architecture, NamesOfAFileAreItsOwnInItsRoom) {
  const std::set<std::string> alone = {"synthetic/house.cc",    "synthetic/office.cc",
                                       "synthetic/room.cc",     "synthetic/value_noise.cc",
                                       "frontend/pair_sums.cc", "frontend/neighbor_search.cc",
                                       "loop/hamming.cc"};
  std::map<std::string, std::string> owner;
  for (const SourceFile& file : tree()) {
    const Room* room = room_of(file.path);
    if (!file.path.ends_with(".cc") || room == nullptr || alone.contains(file.path)) continue;
    if (room->name == "tests" || room->name == "bench" || file.path == "apps/main.cc") continue;
    for (const std::string& name : private_names(file)) {
      const auto [entry, is_new] = owner.emplace(std::string(room->name) + " " + name, file.path);
      EXPECT_TRUE(is_new) << file.path << ": '" << name << "' is also in " << entry->second
                          << "; give one of them another name";
    }
  }
  EXPECT_GT(owner.size(), 500U) << "the files must be understood";
}

TEST(Architecture, TheManualShowsTheIncludeTable) {
  const SourceFile manual("docs/architecture.md", [] {
    std::ifstream stream(std::filesystem::path(CVO_SLAM_SOURCE_DIR) / "docs" / "architecture.md");
    return std::string(std::istreambuf_iterator<char>(stream), {});
  }());
  for (const Room& room : rooms()) {
    EXPECT_THAT(manual.lines, testing::Contains(testing::AllOf(
                                  testing::StartsWith(fmt::format("| `{}/` |", room.name)),
                                  testing::EndsWith(fmt::format("| {} |", documented_row(room))))))
        << "docs/architecture.md: the row of " << room.name << "/ differs from rooms.cc";
  }
}

}  // namespace
}  // namespace cvo_slam::architecture
