// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/loop/loop_detector.h"
#include "cvo_slam/slam/map_state_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

// The policy for a recognised keyframe where the graph does not say where the camera is (tracking
// is lost, or the keyframe is of another submap): there may be several places that look the same
// (perceptual aliasing), and the images alone must tell them apart.

/// Why a verified match need not be registered: too little of the image agrees, or another keyframe
/// of the same submap explains it as well. Empty if it should be.
[[nodiscard]] std::string ambiguity_of_images(const std::vector<LoopMatch>& matches,
                                              std::size_t index, const MapState& map,
                                              const RelocalizationOptions& options);

/// Why a registered match may still be an ambiguous place: its images and clouds agree less than
/// those of one place do, and the camera can hardly have come there. Empty if that is ruled out.
/// `cos_theta` is that of the registration, `now` the time of the image.
[[nodiscard]] std::string ambiguity_of_registration(const LoopMatch& match, double cos_theta,
                                                    const Timestamp& now, const MapState& map,
                                                    const RelocalizationOptions& options);

}  // namespace cvo_slam
