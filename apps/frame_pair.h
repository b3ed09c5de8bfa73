// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// Two frames of one camera that are to be registered.
struct FramePair {
  Camera camera;
  RgbdFrame a;
  RgbdFrame b;
  std::string name_a;              ///< "frame 12" or the file of its colour image
  std::string name_b;              ///< likewise
  std::string source;              ///< the sequence, for people; empty for image files
  std::optional<double> seconds;   ///< from a to b; empty for image files
  std::optional<SE3> T_a_b_truth;  ///< by the sequence's reference, interpolated, where it has both
};

/// Reads what the words of a command line name: the folder of a sequence and two of its frames,
/// each by its number or by its stamp (a number with a point [s]); or the colour and depth image of
/// each of two frames. `camera` is a file or a built-in name; empty = the sequence's own. Throws
/// InputError or OptionError where a frame is unknown or cannot be read, both are the same, or
/// image files come without a camera.
[[nodiscard]] FramePair read_frame_pair(const std::vector<std::string>& words,
                                        const std::string& camera);

}  // namespace cvo_slam
