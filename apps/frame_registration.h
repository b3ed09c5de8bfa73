// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cvo_slam/apps/frame_pair.h"
#include "cvo_slam/frontend/inspection.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/frontend/tracker.h"

namespace cvo_slam {

/// One registration of two frames, with its input.
struct FrameRegistration {
  PointCloud points_a;  ///< selected as for a keyframe
  PointCloud points_b;  ///< selected as for a frame
  RegistrationResult result;
  double length_scale = 0;  ///< last length scale, used for `before` and `after` [m]
  CloudSimilarity before;   ///< similarity at the identity, where the search starts
  CloudSimilarity after;    ///< similarity at the result
  std::string rejection;    ///< why a tracker would reject the result; empty if it would not
  double cpu_seconds = 0;   ///< CPU time of selecting points and registering
};

/// Registers frame b against frame a from the identity, with the tracker's selection, registration
/// and limits. Throws DataError if there is no result.
[[nodiscard]] FrameRegistration register_frames(const FramePair& pair,
                                                const TrackerOptions& options);

/// Returns the standard deviations of a right perturbation of T_a_b, [translation; rotation]: the
/// square roots of the covariance's diagonal [m, rad].
[[nodiscard]] Vector6 standard_deviations(const RegistrationResult& result);

/// Returns all figures as lines of text for people.
[[nodiscard]] std::string to_table(const FramePair& pair, const FrameRegistration& registration);

}  // namespace cvo_slam
