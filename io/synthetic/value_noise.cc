// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/synthetic/box_filter_internal.h"
#include "cvo_slam/io/synthetic/random_internal.h"
#include "cvo_slam/io/synthetic/value_noise_internal.h"

namespace cvo_slam::synthetic {
namespace {

double smooth(double s) { return s * s * s * (s * (6 * s - 15) + 10); }

/// One octave with unit lattice spacing, in [-1, 1].
double octave(std::uint32_t seed, double u, double v) {
  const double column = round_down(u);
  const double row = round_down(v);
  const double a = smooth(u - column);
  const double b = smooth(v - row);
  const std::uint32_t at =
      lattice_position(seed, static_cast<std::int32_t>(column), static_cast<std::int32_t>(row));
  const double top = unit(mixed(at)) * (1 - a) + unit(mixed(at + kStepX)) * a;
  const double bottom = unit(mixed(at + kStepY)) * (1 - a) + unit(mixed(at + kStepX + kStepY)) * a;
  return 2 * (top * (1 - b) + bottom * b) - 1;
}

}  // namespace

double value_noise(std::uint32_t seed, double u, double v, double footprint,
                   const Octaves& octaves) {
  double sum = 0;
  double total = 0;
  double amplitude = 1;
  // In lattice spacings of the octave at hand: halving the spacing doubles them, which is exact.
  double column = u / octaves.largest;
  double row = v / octaves.largest;
  double spacing_in_pixels = octaves.largest / footprint;
  for (int k = 0; k < octaves.count; ++k) {
    const double weight = fade(spacing_in_pixels, 1);
    const auto octave_seed = seed + static_cast<std::uint32_t>(k) * 0x51ED27U;
    if (weight > 0) sum += weight * amplitude * octave(octave_seed, column, row);
    total += amplitude;
    amplitude *= octaves.persistence;
    column *= 2;
    row *= 2;
    spacing_in_pixels *= 0.5;
  }
  return sum / total;
}

}  // namespace cvo_slam::synthetic
