// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cvo_slam {

/// Returns the text of a file, without the byte order mark that some editors put before UTF-8.
/// Throws InputError if the file cannot be read, or is UTF-16.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file);

/// Returns the text that the bytes of a file are, without a byte order mark. Throws InputError,
/// which names `file`, if they are UTF-16.
[[nodiscard]] std::string_view text_of(std::string_view bytes, const std::filesystem::path& file);

}  // namespace cvo_slam
