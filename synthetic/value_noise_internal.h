// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cvo_slam::synthetic {

inline constexpr std::size_t kMaxOctaves = 8;

/// Octaves of value noise: random values on a lattice, interpolated smoothly.
struct Octaves {
  double largest = 0.5;      ///< lattice spacing of the first octave [m]
  std::size_t count = 6;     ///< at most kMaxOctaves; each octave halves the spacing
  double persistence = 0.6;  ///< ratio of the amplitudes of successive octaves
};

/// Returns the sum of the octaves at (u, v) [m], in [-1, 1]. Octaves that a filter of width
/// `footprint` [m] cannot resolve are faded out.
[[nodiscard]] double value_noise(std::uint32_t seed, double u, double v, double footprint,
                                 const Octaves& octaves = {});

/// Computes the octaves with unit lattice spacing at (u, v), (2u, 2v), (4u, 4v) ..., each in [-1,
/// 1].
using OctavesFunction = void (*)(std::uint32_t seed, double u, double v,
                                 std::array<double, kMaxOctaves>& octaves);

/// Returns the compiled versions of the function that this CPU can run, the best one first. Each is
/// compiled for another instruction set; all give the same bits. value_noise() calls the first one.
[[nodiscard]] std::vector<OctavesFunction> octaves_functions();

}  // namespace cvo_slam::synthetic
