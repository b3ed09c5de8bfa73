// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "cvo_slam/render/scene.h"

namespace cvo_slam::render {

/// Colours of values between a least and a largest one: from dark blue over red to yellow, lighter
/// all the way, so that the colour-blind and a printer in grey tell them apart.
class ColorScale {
 public:
  /// Of the values of all paths; from zero where none is negative.
  explicit ColorScale(const Scene& scene);

  [[nodiscard]] bool empty() const { return !(max_ > min_); }
  [[nodiscard]] double min() const { return min_; }
  [[nodiscard]] double max() const { return max_; }
  /// Grey for a value that is not finite.
  [[nodiscard]] Color operator()(double value) const;

 private:
  std::array<Color, 256> table_;
  double min_ = 0;
  double max_ = 0;
};

}  // namespace cvo_slam::render
