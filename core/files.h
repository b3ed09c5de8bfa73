// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace cvo_slam {

/// Returns all bytes of a file. Throws InputError if it cannot be read to its end.
[[nodiscard]] std::string read_file(const std::filesystem::path& file);

/// Returns the text of a file, without the byte order mark that some editors put before UTF-8.
/// Throws InputError if the file cannot be read, or is UTF-16.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file);

/// Returns the text that the bytes of a file are, without a byte order mark. Throws InputError,
/// which names `file`, if they are UTF-16.
[[nodiscard]] std::string_view text_of(std::string_view bytes, const std::filesystem::path& file);

/// Writes a file completely or not at all: the bytes go to a temporary file in the same folder,
/// which is renamed when all are written. An existing file is replaced; for a symbolic link, the
/// file it points to is replaced; devices and pipes are written to directly. Throws OutputError if
/// not all bytes can be written; an existing file is then unchanged.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Returns the CRC-32 of zlib. `before` is that of the bytes before these, if there are any.
[[nodiscard]] std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0);

/// Makes a folder and its missing parents. Returns true if it did not exist. Throws OutputError if
/// it cannot be made.
bool make_folder(const std::filesystem::path& folder);

/// Removes a file or an empty folder if it exists. Throws OutputError if it cannot be removed.
void remove_file(const std::filesystem::path& file);

}  // namespace cvo_slam
