// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace cvo_slam {

/// Writes the bytes as a file, replacing one that exists. Throws OutputError where not all arrive.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Makes the folder, and those that it is in, where they are missing; answers whether it was.
/// Throws OutputError.
bool make_folder(const std::filesystem::path& folder);

/// Removes the file, or the empty folder, where there is one. Throws OutputError.
void remove_file(const std::filesystem::path& file);

}  // namespace cvo_slam
