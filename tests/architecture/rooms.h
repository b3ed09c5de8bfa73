// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace cvo_slam::architecture {

/// A folder of sources, and which others its files may include (its own always).
struct Room {
  std::string_view name;
  std::vector<std::string_view> may_include;
  /// Library code is linked into other people's programs: it never prints, exits or sleeps.
  bool is_library = true;
  /// May start threads and lock: slam/ is the scheduler, io/ prefetches.
  bool may_use_threads = false;
};

/// The include table. docs/architecture.md shows it; a test compares the two.
const std::vector<Room>& rooms();

/// The room a path (relative to the source root) or include ("cvo_slam/" removed) lies in, the
/// innermost where rooms are nested; nullptr where it lies in none.
const Room* room_of(std::string_view path);

}  // namespace cvo_slam::architecture
