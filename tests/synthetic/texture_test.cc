// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/texture.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace cvo_slam::synthetic {
namespace {

constexpr std::array<Pattern, 12> kAllPatterns = {
    Pattern::kPlaster, Pattern::kWood,  Pattern::kBricks,    Pattern::kTiles,
    Pattern::kStripes, Pattern::kPlaid, Pattern::kCarpet,    Pattern::kText,
    Pattern::kPoster,  Pattern::kSpine, Pattern::kLandscape, Pattern::kCollage};

/// Returns the scale of a pattern. Posters of a collage at a scale of 0.1 would have few pixels.
double scale_of(Pattern pattern) { return pattern == Pattern::kCollage ? 0.45 : 0.1; }

Texture texture_of(Pattern pattern) {
  return {pattern, {0.8, 0.7, 0.6}, {0.2, 0.2, 0.3}, scale_of(pattern), 0.4, false, 7};
}

SurfacePoint at(double u, double v, double footprint) { return {u, v, 1, 1, footprint, footprint}; }

/// Root mean square of the difference between the filtered texture and the mean of a fine grid of
/// samples over the same footprint.
double filter_error(const Texture& texture, double footprint) {
  constexpr int kGrid = 12;
  constexpr int kPoints = 150;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double u = 0.1 + 0.8 * std::fmod(i * 0.6180339887, 1.0);
    const double v = 0.1 + 0.8 * i / kPoints;
    double mean = 0;
    for (int k = 0; k < kGrid * kGrid; ++k) {
      const double du = ((k % kGrid + 0.5) / kGrid - 0.5) * footprint;
      const int row = k / kGrid;
      const double dv = ((row + 0.5) / kGrid - 0.5) * footprint;
      mean += sample(texture, at(u + du, v + dv, footprint / kGrid))[1];
    }
    const double error = sample(texture, at(u, v, footprint))[1] - mean / (kGrid * kGrid);
    sum += error * error;
  }
  return std::sqrt(sum / kPoints);
}

// The filtered texture must be close to its true average over the pixel: this keeps images of a
// moving camera consistent. Pixels of a 640x480 image are 2 to 6 mm wide on
// the walls of a room, and more at grazing angles. A point-sampled checker would be off by up to
// 0.25, half the contrast of these textures; what is left are rims that cross a pixel aslant.
TEST(Texture, IsFilteredByThePixelsFootprint) {
  for (const Pattern pattern : kAllPatterns) {
    for (const double footprint : {0.002, 0.006, 0.02}) {
      EXPECT_LT(filter_error(texture_of(pattern), footprint), 0.06)
          << "pattern " << static_cast<int>(pattern) << ", footprint " << footprint;
    }
  }
}

TEST(Texture, StaysInRangeAndFiniteEvenAtTheHorizon) {
  for (const Pattern pattern : kAllPatterns) {
    for (const double footprint : {1e-6, 1e-2, 1e3, 1e9}) {
      const LinearColor color = sample(texture_of(pattern), at(-3.3, 7.1, footprint));
      EXPECT_TRUE((color >= 0).all() && (color <= 1).all()) << static_cast<int>(pattern);
    }
  }
}

TEST(Texture, DependsOnItsSeed) {
  for (const Pattern pattern : kAllPatterns) {
    Texture one = texture_of(pattern);
    Texture other = one;
    other.seed = 8;
    int different = 0;
    for (int i = 0; i < 50; ++i) {
      const SurfacePoint point = at(0.02 * i, 0.5, 1e-3);
      different += (sample(one, point) != sample(other, point)).any() ? 1 : 0;
    }
    EXPECT_GT(different, 40) << static_cast<int>(pattern);
  }
}

TEST(Texture, AQuarterTurnSwapsItsAxes) {
  Texture wood = texture_of(Pattern::kWood);
  const LinearColor straight = sample(wood, {0.3, 0.2, 1, 2, 1e-3, 2e-3});
  wood.quarter_turn = true;
  EXPECT_TRUE((straight == sample(wood, {0.2, 0.3, 2, 1, 2e-3, 1e-3})).all());
}

}  // namespace
}  // namespace cvo_slam::synthetic
