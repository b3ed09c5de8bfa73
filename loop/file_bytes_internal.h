// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cvo_slam {

/// All bytes of a file, in one read. Throws InputError.
[[nodiscard]] std::string read_bytes(const std::filesystem::path& file);

/// Replaces the file. Throws OutputError where not all bytes arrive.
void write_bytes(const std::filesystem::path& file, std::string_view bytes);

}  // namespace cvo_slam
