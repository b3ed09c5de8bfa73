// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/simd.h"
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

class ValueNoise : public testing::Test {
 protected:
  ~ValueNoise() override { pin_simd(SimdPath::kBest); }
};

TEST_F(ValueNoise, IsTheWeightedSumOfItsOctaves) {
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

TEST_F(ValueNoise, LeavesOutWhatAPixelCannotShow) {
  EXPECT_EQ(value_noise(9, 0.4, 0.3, 0.26, kOctaves), 0);  // wider than the largest octave
  EXPECT_NE(value_noise(9, 0.4, 0.3, 0.2, kOctaves), 0);
}

TEST_F(ValueNoise, EveryInstructionSetGivesTheSameBits) {
  for (const auto& [name, path] : simd_path_names()) {
    for (int i = 0; i < 100; ++i) {
      const double u = 1.3 * std::sin(i);
      const double v = -0.01 * i;
      pin_simd(SimdPath::kBest);
      const double best = value_noise(3, u, v, kFine, kOctaves);
      try {
        pin_simd(path);
      } catch (const OptionError&) {
        break;  // not on this CPU
      }
      EXPECT_EQ(value_noise(3, u, v, kFine, kOctaves), best) << name;
    }
  }
}

}  // namespace
}  // namespace cvo_slam::synthetic
