// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which camera a sequence was recorded with: known from a file, or from evidence inside the
// recording. The name of a folder and the order of a list are no evidence.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/io/dataset/formats_internal.h"

namespace cvo_slam {

/// What is wrong with a sequence is that its camera is not known.
class CameraError : public InputError {
 public:
  explicit CameraError(const InputError& error) : InputError(error) {}
};

struct ChosenCamera {
  Camera camera;
  std::string origin;  ///< why this one, for people
};

/// Returns the camera that the caller gives; else the one of a camera file in the folder of the
/// sequence, in the folder of its images or above; else the built-in one that a file of the
/// recording names, or that the images single out. Throws InputError, which lists the choices, if
/// there is none, and if a camera file of a format that is not read contradicts the built-in one.
[[nodiscard]] ChosenCamera choose_camera(const std::filesystem::path& folder,
                                         const std::optional<Camera>& given,
                                         const DatasetFormat& format, const Sequence& sequence);

/// Returns the name of the built-in camera with which frames re-project into each other, moved by
/// the poses of the reference, several times better than with any other, and not worse than with
/// its own focal length changed; empty if there is none, as without a reference. Frames of two
/// cameras of one model are not told apart by it.
[[nodiscard]] std::optional<std::string> camera_singled_out_by_images(const Sequence& sequence);

/// Returns the poses of the colour camera.
[[nodiscard]] std::vector<StampedPose> reference_of(const Sequence& sequence, const Camera& camera);

}  // namespace cvo_slam
