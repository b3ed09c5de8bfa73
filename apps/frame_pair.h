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
  std::string name_a;              ///< "frame 12", or the file of the colour image
  std::string name_b;              ///< the same for frame b
  std::string source;              ///< name of the sequence; empty for image files
  std::optional<double> seconds;   ///< time from a to b [s]; empty for image files
  std::optional<SE3> T_a_b_truth;  ///< from the interpolated reference, if it covers both
};

/// Reads the frames that the words of a command line name: either the folder of a sequence and two
/// of its frames, each by number or by stamp (a number with a point [s]); or the colour and the
/// depth image of each frame. `camera` is a file or a built-in name; empty = the camera of the
/// sequence. Throws InputError or OptionError if a frame is unknown or cannot be read, if both
/// frames are the same, or if image files come without a camera.
[[nodiscard]] FramePair read_frame_pair(const std::vector<std::string>& words,
                                        const std::string& camera);

}  // namespace cvo_slam
