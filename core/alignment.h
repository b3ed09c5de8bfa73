// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/core/association.h"
#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// What may be done to an estimate before its distance from the reference is taken.
enum class Alignment {
  kNone,  ///< nothing: both are in the same world frame
  kSe3,   ///< rotation and translation
  kSim3,  ///< and a scale, for monocular systems
};

/// p_reference = R * (scale * p_estimate) + t.
struct Similarity {
  SE3 T_reference_estimate;
  double scale = 1;

  /// The pose of a camera in the reference's world: the position is scaled and moved, the
  /// orientation turned.
  [[nodiscard]] SE3 operator*(const SE3& pose) const;
};

/// The alignment of least squared distances between matched positions, in closed form: S. Umeyama,
/// "Least-Squares Estimation of Transformation Parameters Between Two Point Patterns", PAMI 1991,
/// Eqs. (38) to (43). Positions alone count, as in evo and in the tools of the TUM benchmark.
/// Throws DataError where the answer is not unique: fewer than three matches, or the positions of
/// either side lie on one line or point. kNone gives the identity for any input.
[[nodiscard]] Similarity align_positions(const std::vector<MatchedPose>& matches,
                                         Alignment alignment);

/// `poses` of the estimate in the reference's world.
[[nodiscard]] std::vector<StampedPose> transformed(const Similarity& similarity,
                                                   std::vector<StampedPose> poses);

}  // namespace cvo_slam
