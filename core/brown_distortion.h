// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace cvo_slam {

/// Brown's lens distortion of the normalised coordinates (x, y) = (X/Z, Y/Z), in place:
/// D. C. Brown, "Decentering distortion of lenses", 1966, with the coefficients k1, k2, p1, p2, k3
/// in the order of OpenCV. Inline and for any scalar, so that loops over images vectorise.
template <typename Scalar>
inline void apply_brown_distortion(const std::array<Scalar, 5>& coefficients, Scalar& x,
                                   Scalar& y) {
  const auto& [k1, k2, p1, p2, k3] = coefficients;
  const Scalar r2 = x * x + y * y;
  const Scalar radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const Scalar twice_xy = 2 * x * y;
  const Scalar distorted_x = x * radial + p1 * twice_xy + p2 * (r2 + 2 * x * x);
  y = y * radial + p1 * (r2 + 2 * y * y) + p2 * twice_xy;
  x = distorted_x;
}

}  // namespace cvo_slam
