// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The files of a map's memory.
#pragma once

#include <filesystem>
#include <functional>

#include "cvo_slam/core/map.h"
#include "cvo_slam/io/map_header_internal.h"

namespace cvo_slam {

/// Writes the memory into a folder: camera.yaml, keyframes.csv, keyframes.bin. Throws OutputError.
void write_memory(const std::filesystem::path& folder, const MapMemory& memory);
/// Reads the memory from files that are as the header says. Throws InputError.
[[nodiscard]] MapMemory read_memory(const std::filesystem::path& folder, const MapHeader& header);

/// Calls `write` with a folder beside, and lets that take the place of `folder` at once. Throws
/// OutputError; an existing folder is then unchanged.
void replace_folder(const std::filesystem::path& folder,
                    const std::function<void(const std::filesystem::path&)>& write);

}  // namespace cvo_slam
