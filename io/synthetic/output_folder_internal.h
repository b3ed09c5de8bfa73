// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace cvo_slam::synthetic {

/// The file that marks a folder as a synthetic sequence.
inline constexpr const char* kMarkerFile = "synthetic.yaml";

/// Makes the folder ready: creates it, or removes the sequence that an earlier call wrote there.
/// Throws OutputError where it holds anything else, so that nothing of the user's is lost.
void prepare_output_folder(const std::filesystem::path& folder);

/// Writes a whole file; throws OutputError where that fails, at the latest on closing (full disk).
void write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace cvo_slam::synthetic
