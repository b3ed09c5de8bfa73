// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"

namespace cvo_slam {

/// A frame from two image files that are of no sequence, as a Dataset would read it: depth is
/// registered to colour where the camera calls for it. Its stamps are 0. Throws InputError where a
/// file is missing or broken, or the depth image has no valid pixel; OptionError for an impossible
/// camera.
[[nodiscard]] RgbdFrame read_rgbd_images(const std::filesystem::path& color,
                                         const std::filesystem::path& depth, const Camera& camera);

}  // namespace cvo_slam
