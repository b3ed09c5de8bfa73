// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cvo_slam/apps/frame_pair.h"
#include "cvo_slam/frontend/inspection.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/frontend/tracker_options.h"

namespace cvo_slam {

/// One registration of two frames, and what went into it.
struct FrameRegistration {
  PointCloud points_a;  ///< as of a keyframe
  PointCloud points_b;  ///< as of a frame
  RegistrationResult result;
  double length_scale = 0;  ///< the last one [m]: of `before` and `after`
  CloudSimilarity before;   ///< at the identity, where the search starts
  CloudSimilarity after;    ///< at the result
  std::string doubt;        ///< why a tracker would not believe it; empty where it would
  double cpu_seconds = 0;   ///< of selecting points and registering
};

/// Registers frame b against frame a from the identity, with the tracker's selection, registration
/// and limits. Throws DataError where there is no result.
[[nodiscard]] FrameRegistration register_frames(const FramePair& pair,
                                                const TrackerOptions& options);

/// Returns the standard deviations of a right perturbation of T_a_b, [translation; rotation]: the
/// square roots of the covariance's diagonal [m, rad].
[[nodiscard]] Vector6 standard_deviations(const RegistrationResult& result);

/// All figures as lines of text for people.
[[nodiscard]] std::string to_table(const FramePair& pair, const FrameRegistration& registration);

}  // namespace cvo_slam
