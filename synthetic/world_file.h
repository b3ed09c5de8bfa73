// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {

/// Reads a world of the format that docs/reference/synthetic-worlds.md describes. Textures and
/// tremor without a seed of their own get one from `seed`. Throws InputError with file and line for
/// an unknown key or word (the message gives the nearest one), a bad number, an impossible size,
/// too few viewpoints, and where the camera would come nearer than 5 cm to a surface (with the
/// time).
[[nodiscard]] World read_world(const std::filesystem::path& file, std::uint32_t seed = 1);
/// The same of a text; `file` is for messages.
[[nodiscard]] World parse_world(const std::string& text, const std::filesystem::path& file,
                                std::uint32_t seed = 1);

/// The text of a file that gives this very world again, to the last bit.
[[nodiscard]] std::string world_text(const World& world);

}  // namespace cvo_slam::synthetic
