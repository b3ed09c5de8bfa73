// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// A coloured point cloud as a structure of arrays; all arrays have size() entries.
struct PointCloud {
  /// blue, green, red, dI/dx, dI/dy, on the scale of 8-bit values.
  static constexpr std::size_t kFeatures = 5;

  std::vector<float> x, y, z;  ///< position in the camera frame [m]
  std::array<std::vector<float>, kFeatures> features;
  std::vector<float> u, v;  ///< pixel the point was seen at [px]

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] bool empty() const { return x.empty(); }
  [[nodiscard]] Vector3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }

  void clear() { resize(0); }
  void resize(std::size_t n) {
    for (auto* array : {&x, &y, &z, &u, &v}) array->resize(n);
    for (auto& feature : features) feature.resize(n);
  }
};

}  // namespace cvo_slam
