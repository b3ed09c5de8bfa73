// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A fifth of what a frame of a synthetic world costs is noise. Google Highway compiles this file
// once for each instruction set and picks one at run time; compilers make the vector instructions.
// The result is the same to the last bit for all sets; their list is that of the tracker
// (frontend/pair_sums.cc), so that a set pinned there is pinned here.
#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_AVX3_DL)
#define HWY_COMPILE_ALL_ATTAINABLE
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cvo_slam/synthetic/value_noise.cc"
#include <array>
#include <cstddef>

#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "cvo_slam/synthetic/box_filter_internal.h"
#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/value_noise_internal.h"

HWY_BEFORE_NAMESPACE();
namespace cvo_slam::synthetic::HWY_NAMESPACE {
namespace {

double smooth(double s) { return s * s * s * (s * (6 * s - 15) + 10); }

/// round_down() in the range of std::int32_t, for which there are vector instructions.
double floor_of(double x) {
  const double whole = static_cast<std::int32_t>(x);
  return whole - (whole > x ? 1.0 : 0.0);
}

/// unit(mixed(position)); of signed integers there is a vector conversion.
double value_at(std::uint32_t position) {
  constexpr std::uint32_t kSign = 0x80000000U;
  constexpr double kScale = 1.0 / 4294967296.0;
  return (static_cast<double>(static_cast<std::int32_t>(mixed(position) ^ kSign)) + kSign) * kScale;
}

/// Octaves with unit lattice spacing at (u, v), (2u, 2v), (4u, 4v) ..., each in [-1, 1]. All of
/// them, as compilers turn a loop without branches and of a fixed length into vector instructions.
void all_octaves(std::uint32_t seed, double u, double v, std::array<double, kMaxOctaves>& octaves) {
  constexpr std::array<double, kMaxOctaves> kFrequencies = {1, 2, 4, 8, 16, 32, 64, 128};
  constexpr std::array<std::uint32_t, kMaxOctaves> kNumbers = {0, 1, 2, 3, 4, 5, 6, 7};
  for (std::size_t k = 0; k < kMaxOctaves; ++k) {
    const double column = floor_of(u * kFrequencies[k]);  // exact, as are all powers of two
    const double row = floor_of(v * kFrequencies[k]);
    const double a = smooth(u * kFrequencies[k] - column);
    const double b = smooth(v * kFrequencies[k] - row);
    const std::uint32_t at =
        lattice_position(seed + kNumbers[k] * 0x51ED27U, static_cast<std::int32_t>(column),
                         static_cast<std::int32_t>(row));
    const double top = value_at(at) * (1 - a) + value_at(at + kStepX) * a;
    const double bottom = value_at(at + kStepY) * (1 - a) + value_at(at + kStepX + kStepY) * a;
    octaves[k] = 2 * (top * (1 - b) + bottom * b) - 1;
  }
}

}  // namespace
}  // namespace cvo_slam::synthetic::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cvo_slam::synthetic {

HWY_EXPORT(all_octaves);

double value_noise(std::uint32_t seed, double u, double v, double footprint,
                   const Octaves& octaves) {
  std::array<double, kMaxOctaves> noise;
  HWY_DYNAMIC_DISPATCH(all_octaves)(seed, u / octaves.largest, v / octaves.largest, noise);
  double sum = 0;
  double total = 0;
  double amplitude = 1;
  double spacing_in_pixels = octaves.largest / footprint;
  for (std::size_t k = 0; k < octaves.count; ++k) {
    const double weight = fade(spacing_in_pixels, 1);
    if (weight > 0) sum += weight * amplitude * noise[k];
    total += amplitude;
    amplitude *= octaves.persistence;
    spacing_in_pixels *= 0.5;
  }
  return sum / total;
}

}  // namespace cvo_slam::synthetic
#endif
