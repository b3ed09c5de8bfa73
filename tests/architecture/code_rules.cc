// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/tests/architecture/finding_internal.h"
#include "cvo_slam/tests/architecture/rooms.h"

namespace cvo_slam::architecture {
namespace {

bool is_library(const SourceFile& file) {
  const Room* room = room_of(file.path);
  return file.is_cpp() && room != nullptr && room->is_library;
}

Findings in_libraries(const SourceFile& file, const std::regex& pattern,
                      const std::string& advice) {
  return is_library(file) ? find_all(file, file.code, pattern, advice) : Findings();
}

}  // namespace

Findings libraries_do_not_print(const SourceFile& file) {
  static const std::regex pattern(
      R"(\bstd(out|err)\b|\bc(out|err|log)\b|<(iostream|print|syncstream)>|)"
      R"(\bv?f?printf\s*\(|\bf?put(s|c|char)\s*\(|\bperror\s*\(|\bfmt::(v?print)\b|\bstd::print)");
  return in_libraries(file, pattern, "library code never prints; return it or throw an Error");
}

Findings libraries_do_not_end_the_program(const SourceFile& file) {
  // Behind '.' or '>' it is a member function of the same name.
  static const std::regex pattern(
      R"((^|[^\w.>])(exit|_exit|_Exit|quick_exit|at_quick_exit|abort|terminate|raise)\s*\()");
  return in_libraries(file, pattern, "library code never ends the program; throw an Error");
}

Findings libraries_do_not_sleep(const SourceFile& file) {
  static const std::regex pattern(R"(\b(sleep_for|sleep_until|u?sleep|nanosleep)\s*\()");
  return in_libraries(file, pattern, "library code never sleeps; wait on what you wait for");
}

Findings libraries_set_nothing_process_wide(const SourceFile& file) {
  static const std::regex pattern(
      R"(\b(setNumThreads|setUseOptimized|setRNGSeed|theRNG|setlocale|putenv|setenv|srand|rand)\s*\()"
      R"(|\bstd::locale::global\b|\bglobal_control\b)");
  return in_libraries(file, pattern,
                      "it belongs to the whole process, that is to the embedder; make it a "
                      "parameter or a member");
}

Findings threads_belong_to_the_scheduler(const SourceFile& file) {
  const Room* room = room_of(file.path);
  if (!is_library(file) || room->may_use_threads) return {};
  static const std::regex pattern(
      R"(\bstd::(jthread|thread|async|(recursive_|shared_|timed_)?mutex|condition_variable)\b)");
  return find_all(file, file.code, pattern,
                  "threads and locks live in slam/ (and the prefetch of io/); use core's Executor "
                  "for loops");
}

Findings memory_has_owners(const SourceFile& file) {
  if (!file.is_cpp()) return {};
  // A test that counts allocations replaces the global operators.
  const bool counts = std::any_of(file.code.begin(), file.code.end(), [](const std::string& line) {
    return line.find("void* operator new(") != std::string::npos;
  });
  if (counts && file.path.starts_with("tests/")) return {};
  static const std::regex deleted_function(R"(=\s*delete\b)");
  static const std::regex pattern(
      R"(\bnew\b\s*[\w:(]|\bdelete\b|(^|[^\w.>])(malloc|calloc|realloc|free)\s*\()");
  std::vector<std::string> code;
  for (const std::string& line : file.code) {
    code.push_back(std::regex_replace(line, deleted_function, ""));
  }
  return find_all(file, code, pattern,
                  "use a container, std::make_unique or std::make_shared; memory has an owner");
}

Findings headers_open_no_namespaces(const SourceFile& file) {
  if (!file.is_header()) return {};
  static const std::regex pattern(R"(\busing\s+namespace\b)");
  return find_all(file, file.code, pattern,
                  "it would open the namespace for whoever includes the header; qualify names");
}

}  // namespace cvo_slam::architecture
