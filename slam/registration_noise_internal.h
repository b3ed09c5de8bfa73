// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/LU>

#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// The part of a registration's error that its own information does not know of.
struct RegistrationNoise {
  double translation = 0;  ///< standard deviation [m]
  double rotation = 0;     ///< [rad]

  /// The information with this noise on top.
  [[nodiscard]] Matrix6 added_to(const Matrix6& information) const {
    AlignedMatrix6 covariance = AlignedMatrix6(information).inverse();
    covariance.diagonal().head<3>().array() += translation * translation;
    covariance.diagonal().tail<3>().array() += rotation * rotation;
    const AlignedMatrix6 sum = covariance.inverse();
    return 0.5 * (sum + sum.transpose());
  }
};

}  // namespace cvo_slam
