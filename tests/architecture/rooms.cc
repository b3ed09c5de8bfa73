// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/tests/architecture/rooms.h"

namespace cvo_slam::architecture {

const std::vector<Room>& rooms() {
  static const std::vector<Room> table = {
      {.name = "core", .may_include = {}},
      {.name = "frontend", .may_include = {"core"}},
      {.name = "backend", .may_include = {"core"}},
      {.name = "loop", .may_include = {"core"}},
      {.name = "io", .may_include = {"core"}, .may_use_threads = true},
      {.name = "io/render", .may_include = {"core", "io"}},
      {.name = "io/synthetic", .may_include = {"core", "io"}},
      {.name = "slam",
       .may_include = {"core", "frontend", "backend", "loop"},
       .may_use_threads = true},
      {.name = "apps",
       .may_include = {"core", "frontend", "backend", "loop", "io", "io/render", "io/synthetic",
                       "slam"},
       .is_library = false,
       .may_use_threads = true},
      {.name = "bench",
       .may_include = {"core", "frontend", "backend", "loop", "io", "io/render", "io/synthetic",
                       "slam", "apps"},
       .is_library = false,
       .may_use_threads = true},
      {.name = "tests",
       .may_include = {"core", "frontend", "backend", "loop", "io", "io/render", "io/synthetic",
                       "slam", "apps", "bench"},
       .is_library = false,
       .may_use_threads = true},
  };
  return table;
}

const Room* room_of(std::string_view path) {
  const Room* innermost = nullptr;
  for (const Room& room : rooms()) {
    const bool inside = path.size() > room.name.size() && path.starts_with(room.name) &&
                        path[room.name.size()] == '/';
    if (inside && (innermost == nullptr || room.name.size() > innermost->name.size())) {
      innermost = &room;
    }
  }
  return innermost;
}

}  // namespace cvo_slam::architecture
