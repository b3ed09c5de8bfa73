// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace cvo_slam::synthetic {

/// The file that marks a folder as a synthetic sequence.
inline constexpr const char* kMarkerFile = "synthetic.yaml";

/// Makes the folder ready: creates it, or removes the sequence that an earlier call wrote there.
/// Throws OutputError where it holds anything else, so that nothing of the user's is lost.
void prepare_output_folder(const std::filesystem::path& folder);

}  // namespace cvo_slam::synthetic
