// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace cvo_slam::synthetic {

inline constexpr std::size_t kMaxOctaves = 8;

/// Octaves of value noise: random values on a lattice, interpolated smoothly.
struct Octaves {
  double largest = 0.5;      ///< lattice spacing of the first octave [m]
  std::size_t count = 6;     ///< at most kMaxOctaves; each octave halves the spacing
  double persistence = 0.6;  ///< amplitude ratio of successive octaves
};

/// The sum of the octaves at (u, v) [m], amplitudes normalised so that it stays in [-1, 1].
/// Octaves that a filter of width `footprint` [m] cannot resolve are faded out.
[[nodiscard]] double value_noise(std::uint32_t seed, double u, double v, double footprint,
                                 const Octaves& octaves = {});

}  // namespace cvo_slam::synthetic
