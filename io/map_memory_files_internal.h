// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The files of a map's memory.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "cvo_slam/core/map.h"

namespace cvo_slam {

/// The file that makes a folder one of a map with memory. It names all others.
inline constexpr std::string_view kMapHeader = "map.yaml";

/// Writes the memory into a folder: camera.yaml, keyframes.csv, keyframes.bin. Throws OutputError.
void write_memory(const std::filesystem::path& folder, const MapMemory& memory);
/// Reads the memory from files that are as the header says. Throws InputError.
[[nodiscard]] MapMemory read_memory(const std::filesystem::path& folder);

/// Writes the header of a folder, with the size and the checksum of every file in it.
void write_header(const std::filesystem::path& folder, const MapMemory& memory);
/// Throws InputError unless the version is ours and every file but those that read_memory() reads
/// is as the header says.
void check_header(const std::filesystem::path& folder);

/// Calls `write` with a folder beside, and lets that take the place of `folder` at once. Throws
/// OutputError; an existing folder is then unchanged.
void replace_folder(const std::filesystem::path& folder,
                    const std::function<void(const std::filesystem::path&)>& write);

}  // namespace cvo_slam
