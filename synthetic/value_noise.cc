// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Noise takes a fifth of the time of a synthetic frame. Google Highway compiles the first part of
// this file once for each instruction set; compilers make the vector instructions. The version is
// chosen here, and not by Highway's process-wide state, which the tracker's option `simd` changes.
// All versions give the same result to the last bit.

#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_AVX3_DL)
#define HWY_COMPILE_ALL_ATTAINABLE
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cvo_slam/synthetic/value_noise.cc"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "cvo_slam/synthetic/box_filter_internal.h"
#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/value_noise_internal.h"

HWY_BEFORE_NAMESPACE();
namespace cvo_slam::synthetic::HWY_NAMESPACE {
namespace {

double smooth(double s) { return s * s * s * (s * (6 * s - 15) + 10); }

/// Returns round_down() in the range of std::int32_t, for which there are vector instructions.
double floor_of(double x) {
  const double whole = static_cast<std::int32_t>(x);
  return whole - (whole > x ? 1.0 : 0.0);
}

/// Returns unit(mixed(position)) through signed integers, for which there is a vector conversion.
double value_at(std::uint32_t position) {
  constexpr std::uint32_t kSign = 0x80000000U;
  constexpr double kScale = 1.0 / 4294967296.0;
  return (static_cast<double>(static_cast<std::int32_t>(mixed(position) ^ kSign)) + kSign) * kScale;
}

/// An OctavesFunction. It always computes all octaves: compilers turn a loop of fixed length
/// without branches into vector instructions.
void all_octaves(std::uint32_t seed, double u, double v, std::array<double, kMaxOctaves>& octaves) {
  constexpr std::array<double, kMaxOctaves> kFrequencies = {1, 2, 4, 8, 16, 32, 64, 128};
  constexpr std::array<std::uint32_t, kMaxOctaves> kNumbers = {0, 1, 2, 3, 4, 5, 6, 7};
  for (std::size_t k = 0; k < kMaxOctaves; ++k) {
    const double column = floor_of(u * kFrequencies[k]);  // exact: factors are powers of two
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

namespace {

/// The instruction sets of this CPU, found when the program is loaded: nobody has restricted
/// Highway to fewer of them by then.
const std::int64_t kCpuTargets = hwy::SupportedTargets();

}  // namespace

std::vector<OctavesFunction> octaves_functions() {
  std::vector<OctavesFunction> functions;
  // Highway's better instruction sets have the lower bits. The last version runs on every CPU.
  const std::int64_t runnable = (kCpuTargets & HWY_TARGETS) | HWY_STATIC_TARGET;
  for (std::int64_t left = runnable; left != 0; left &= left - 1) {
    hwy::ChosenTarget chosen;
    chosen.Update(left & -left);
    // Without a choice, Highway makes a table of one version.
    const std::size_t last = std::size(HWY_DISPATCH_TABLE(all_octaves)) - 1;
    functions.push_back(HWY_DISPATCH_TABLE(all_octaves)[std::min(chosen.GetIndex(), last)]);
  }
  return functions;
}

double value_noise(std::uint32_t seed, double u, double v, double footprint,
                   const Octaves& octaves) {
  static const OctavesFunction best = octaves_functions().front();
  std::array<double, kMaxOctaves> noise;
  best(seed, u / octaves.largest, v / octaves.largest, noise);
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
