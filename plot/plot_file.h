// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// The figure as SVG 1.1 text; the same figure gives the same bytes.
/// Throws OptionError for an impossible size, number of columns or image, as the writers do.
[[nodiscard]] std::string to_svg(const Figure& figure);

/// The figure as the bytes of a PNG of its size in pixels.
[[nodiscard]] std::string to_png(const Figure& figure);

/// Writes the figure as SVG. Throws OutputError.
void write_svg(const std::filesystem::path& file, const Figure& figure);

/// Writes the figure as PNG. Throws OutputError.
void write_png(const std::filesystem::path& file, const Figure& figure);

}  // namespace cvo_slam
