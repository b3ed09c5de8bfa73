// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cvo_slam {

/// Returns all bytes of a file. Throws InputError where it cannot be read to its end.
[[nodiscard]] std::string read_file(const std::filesystem::path& file);

/// Writes a file whole or not at all: the bytes go to a file beside it, which takes its name when
/// all have arrived. A file that exists is replaced; what a symbolic link points to is replaced
/// where it lies, and devices and pipes are written to directly. Throws OutputError where not all
/// bytes arrive; the file that was there is then as it was.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Makes a folder and the missing ones above it. Returns true if it did not exist. Throws
/// OutputError.
bool make_folder(const std::filesystem::path& folder);

/// Removes a file or an empty folder if it exists. Throws OutputError.
void remove_file(const std::filesystem::path& file);

}  // namespace cvo_slam
