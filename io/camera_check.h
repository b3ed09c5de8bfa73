// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What speaks against the camera that a recording is read with.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// How well pairs of frames agree when one is moved into the other by known poses: medians over the
/// pairs. Only a comparison with another camera on the same pairs means much.
struct Reprojection {
  std::size_t pairs = 0;   ///< number of pairs
  double color_error = 0;  ///< mean squared difference of the grey values, each at most 40^2
  double still_error = 0;  ///< the same for images that are laid over each other unmoved
  double depth_error = 0;  ///< median of |expected - measured| / expected depth
};

/// Returns the agreement of a few pairs of frames, spread over the recording and as far apart as
/// they still overlap well. `poses` are poses of the colour camera, for example the reference or an
/// estimate. Empty if there are no such pairs or the camera moves too little.
[[nodiscard]] std::optional<Reprojection> measure_reprojection(
    const Dataset& data, const std::vector<StampedPose>& poses);

/// Returns what is unlikely in the values of a camera, one line each: a principal point far from
/// the centre of the image, a field of view that no such camera has, a distortion that folds back
/// within the image.
[[nodiscard]] std::vector<std::string> camera_warnings(const Camera& camera);

/// Returns a warning if frames agree badly with each other. `poses` says whose poses they are
/// ("the ground truth"). Empty if they agree.
[[nodiscard]] std::optional<std::string> reprojection_warning(const Reprojection& agreement,
                                                              const std::string& poses);

}  // namespace cvo_slam
