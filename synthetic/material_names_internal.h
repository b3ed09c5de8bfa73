// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cvo_slam/synthetic/texture.h"

namespace cvo_slam::synthetic {

// The words of world files.

/// The materials of materials_internal.h by name.
[[nodiscard]] const std::vector<std::pair<std::string, Texture>>& named_materials();
[[nodiscard]] const std::vector<std::pair<std::string, Pattern>>& pattern_names();

}  // namespace cvo_slam::synthetic
