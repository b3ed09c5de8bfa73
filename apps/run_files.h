// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>

#include "cvo_slam/apps/run_report.h"

namespace cvo_slam {

/// A file that a run may leave in its folder.
struct RunFile {
  const char* name;
  const char* content;  ///< for people
};

/// All files of a run except the pictures of loops (loop_pictures.h).
[[nodiscard]] std::span<const RunFile> run_files();

/// Makes `folder` if it does not exist, marks it as the folder of a run, and removes the files that
/// an earlier run left in it, so that none is taken for a file of the next run; other files stay.
/// Throws OutputError if the folder has files and no mark, because files of these names may be the
/// user's: `overwrite` takes it all the same.
void prepare_folder(const std::filesystem::path& folder, bool overwrite);

/// Writes every file of a run into `folder`, which exists. Adds to the report's notes what a
/// picture lacks. Throws OutputError.
void write_run(const std::filesystem::path& folder, RunReport& report);

}  // namespace cvo_slam
