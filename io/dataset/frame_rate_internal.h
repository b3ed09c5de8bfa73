// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/io/dataset/formats_internal.h"

namespace cvo_slam {

/// A frame rate that fits the images better than the one that was assumed.
struct LikelyFrameRate {
  double rate = 0;   ///< [Hz]
  std::string note;  ///< for people: why
};

/// Looks at pairs of neighbouring images of a sequence whose stamps are counted at an assumed
/// `rate` [Hz]. If the camera would turn faster than one that is held in a hand, the images were
/// taken at a lower rate: one at which it turns by 0.3 rad/s, as is usual. Empty if the rate that
/// was assumed can be right. Images that cannot be read are left out.
[[nodiscard]] std::optional<LikelyFrameRate> likely_frame_rate(const Sequence& sequence,
                                                               const Camera& camera, double rate);

}  // namespace cvo_slam
