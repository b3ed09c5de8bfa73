// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/tests/architecture/rooms.h"

#include <algorithm>

namespace cvo_slam::architecture {

const std::vector<Room>& rooms() {
  static const std::vector<Room> table = {
      {.name = "core", .may_include = {}},
      {.name = "frontend", .may_include = {"core"}},
      {.name = "backend", .may_include = {"core"}},
      {.name = "loop", .may_include = {"core"}},
      {.name = "slam",
       .may_include = {"core", "frontend", "backend", "loop"},
       .may_use_threads = true},
      {.name = "io", .may_include = {"core"}, .may_use_threads = true},
      {.name = "plot", .may_include = {"core"}},
      {.name = "render", .may_include = {"core", "io", "plot"}},
      {.name = "synthetic", .may_include = {"core", "io"}},
      {.name = "apps",
       .may_include = {"core", "frontend", "backend", "loop", "slam", "io", "plot", "render",
                       "synthetic"},
       .is_library = false,
       .may_use_threads = true},
      {.name = "python",
       .may_include = {"core", "frontend", "backend", "loop", "slam", "io", "plot", "render",
                       "synthetic"},
       .is_library = false,
       .may_use_threads = true},
      {.name = "bench",
       .may_include = {"core", "frontend", "backend", "loop", "slam", "io", "plot", "render",
                       "synthetic", "apps"},
       .is_library = false,
       .may_use_threads = true},
      {.name = "tests",
       .may_include = {"core", "frontend", "backend", "loop", "slam", "io", "plot", "render",
                       "synthetic", "apps", "bench"},
       .is_library = false,
       .may_use_threads = true},
  };
  return table;
}

const Room* room_of(std::string_view path) {
  const auto room = std::find_if(rooms().begin(), rooms().end(), [path](const Room& candidate) {
    return path.size() > candidate.name.size() && path.starts_with(candidate.name) &&
           path[candidate.name.size()] == '/';
  });
  return room == rooms().end() ? nullptr : &*room;
}

}  // namespace cvo_slam::architecture
