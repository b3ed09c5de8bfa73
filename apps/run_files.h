// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>

namespace cvo_slam {

/// A file that a run may leave in its folder.
struct RunFile {
  const char* name;
  const char* content;  ///< for people
};

/// All of them but the pictures of loops (loop_pictures.h).
[[nodiscard]] std::span<const RunFile> run_files();

/// Removes the files that an earlier run left in `folder`, so that none is taken for one of the
/// next run; other files stay. Throws OutputError.
void remove_run(const std::filesystem::path& folder);

}  // namespace cvo_slam
