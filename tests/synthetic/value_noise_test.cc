// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/value_noise_internal.h"

namespace cvo_slam::synthetic {
namespace {

constexpr Octaves kOctaves{.largest = 0.25, .count = kMaxOctaves, .persistence = 0.7};
constexpr double kFine = 1e-4;  // [m] a footprint that fades no octave out

/// The definition: values on a lattice, blended by 6 s^5 - 15 s^4 + 10 s^3 along both axes.
double one_octave(std::uint32_t seed, double u, double v) {
  const double column = std::floor(u);
  const double row = std::floor(v);
  const auto value = [&](int i, int j) {
    return hash_unit(seed, static_cast<std::int32_t>(column) + i,
                     static_cast<std::int32_t>(row) + j);
  };
  const auto blend = [](double s) { return s * s * s * (s * (6 * s - 15) + 10); };
  const double a = blend(u - column);
  const double b = blend(v - row);
  return 2 * std::lerp(std::lerp(value(0, 0), value(1, 0), a),
                       std::lerp(value(0, 1), value(1, 1), a), b) -
         1;
}

TEST(ValueNoise, IsTheWeightedSumOfItsOctaves) {
  for (int i = -50; i < 50; ++i) {
    const double u = 0.0371 * i;
    const double v = 0.9 - 0.0173 * i;
    double sum = 0;
    double total = 0;
    for (std::uint32_t k = 0; k < kMaxOctaves; ++k) {
      const double frequency = std::ldexp(4.0, static_cast<int>(k));  // 1 / 0.25 m, doubled
      const double amplitude = std::pow(0.7, k);
      sum += amplitude * one_octave(9 + k * 0x51ED27U, frequency * u, frequency * v);
      total += amplitude;
    }
    EXPECT_NEAR(value_noise(9, u, v, kFine, kOctaves), sum / total, 1e-12);
  }
}

TEST(ValueNoise, LeavesOutWhatAPixelCannotShow) {
  EXPECT_EQ(value_noise(9, 0.4, 0.3, 0.26, kOctaves), 0);  // wider than the largest octave
  EXPECT_NE(value_noise(9, 0.4, 0.3, 0.2, kOctaves), 0);
}

TEST(ValueNoise, EveryInstructionSetGivesTheSameBits) {
  const auto functions = octaves_functions();
  ASSERT_FALSE(functions.empty());
  std::array<double, kMaxOctaves> best{};
  std::array<double, kMaxOctaves> other{};
  for (std::size_t k = 1; k < functions.size(); ++k) {
    for (int i = 0; i < 100; ++i) {
      const double u = 1.3 * std::sin(i);
      const double v = -0.01 * i;
      functions[0](3, u, v, best);
      functions[k](3, u, v, other);
      EXPECT_EQ(other, best) << "version " << k;
    }
  }
}

// The tracker's option `simd` changes Highway's choice for the whole process. The noise used to
// follow it, so that the speed of the simulator depended on an option of the tracker.
TEST(ValueNoise, DoesNotFollowHighwaysProcessWideChoice) {
  const auto functions = octaves_functions();
  hwy::DisableTargets(~(HWY_EMU128 | HWY_SCALAR));
  const auto restricted = octaves_functions();
  hwy::DisableTargets(0);
  EXPECT_EQ(restricted, functions);
}

}  // namespace
}  // namespace cvo_slam::synthetic
