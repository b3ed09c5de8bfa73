// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"

namespace cvo_slam {

/// Reads a camera from a YAML file with the keys
///
///     name                           default: the name of the file
///     width, height, fx, fy, cx, cy  of the colour camera [px]
///     distortion                     k1, k2, p1, p2, k3 as in OpenCV; default: none
///     depth_scale                    units of the depth image per metre
///     readout_time                   of a rolling shutter, first to last row [s]; default: 0
///     noise                          depth_floor [m], depth_quadratic [1/m], pixel [px], as in
///                                    SensorNoise; a key that is missing has its default
///     depth                          a depth camera, if depth is not registered to colour: width,
///                                    height, fx, fy, cx, cy, distortion and T_color_depth, the
///                                    four rows of a rigid 4x4 matrix [m]
///
/// or from a settings file of ORB-SLAM2, ORB-SLAM3 or OpenVSLAM, which is recognised by its keys
/// "Camera.fx", "Camera1.fx" and their kin. Of these, a key that says that the lens or the images
/// are others than those of a pinhole camera with the five coefficients above is refused by name
/// (another Camera.model or Camera.type, k4 to k6 that are not 0, resized images, a second camera),
/// and so is a key "Camera.*" that is not known. Keys that do not describe the camera are ignored.
/// Throws InputError with file, line and key.
[[nodiscard]] Camera read_camera(const std::filesystem::path& file);

/// Writes a camera as YAML. read_camera() returns the same numbers, except that it rounds the
/// rotation of a depth camera to the nearest rotation matrix. Throws OutputError.
void write_camera(const std::filesystem::path& file, const Camera& camera);

/// Returns a built-in camera: `config/cameras/<name>.yaml`. Throws OptionError, which lists the
/// names, if there is none of that name.
[[nodiscard]] Camera builtin_camera(const std::string& name);
/// Returns the names that builtin_camera() knows.
[[nodiscard]] std::vector<std::string> builtin_camera_names();

/// Returns the camera that a user gave as the name of a built-in camera or as a file.
/// Throws InputError.
[[nodiscard]] Camera find_camera(const std::string& name_or_file);

}  // namespace cvo_slam
