// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numpy arrays in and out. What an array must be is checked here, with an error that says what was
// expected and what came: TypeError for another type of elements, ValueError for another shape or
// an impossible value.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/core/trajectory.h"

namespace cvo_slam::python {

using Doubles = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// Returns numbers as a contiguous array of doubles of the given shape, in which -1 stands for any
/// size. `name` is what the caller calls the argument.
[[nodiscard]] Doubles doubles_from(const pybind11::object& object,
                                   const std::vector<pybind11::ssize_t>& shape,
                                   const std::string& name);

/// Returns a pose from a rigid 4x4 matrix, rounded to the nearest rotation. Throws ValueError if it
/// is off by more than 1e-4.
[[nodiscard]] SE3 pose_from(const pybind11::object& object, const std::string& name);
/// Returns one from the 16 values of a row-major matrix.
[[nodiscard]] SE3 pose_from(const double* values, const std::string& name);
/// Returns a 6x6 matrix.
[[nodiscard]] Matrix6 matrix6_from(const pybind11::object& object, const std::string& name);

[[nodiscard]] Doubles to_array(const SE3& pose);
[[nodiscard]] Doubles to_array(const Matrix6& matrix);
[[nodiscard]] Doubles to_array(const Vector3& vector);
/// Returns an array of shape (N, 4, 4).
[[nodiscard]] Doubles to_array(const std::vector<StampedPose>& poses);
/// Returns the seconds of the stamps, of shape (N).
[[nodiscard]] Doubles stamps_of(const std::vector<StampedPose>& poses);

/// Returns the double that is nearest to a stamp [s]; stamp_from() gives the same stamp back.
[[nodiscard]] inline double seconds_of(const Timestamp& stamp) {
  return static_cast<double>(stamp.nanoseconds()) / 1e9;
}
/// Returns a stamp with the digits that Python prints of the number, at least six decimals: a stamp
/// that was read from a file is written back as it was.
[[nodiscard]] Timestamp stamp_from(double seconds, const std::string& name);

/// Returns the poses of stamps [s] in ascending order, of shape (N), and poses of shape (N, 4, 4).
[[nodiscard]] std::vector<StampedPose> stamped_poses_from(const pybind11::object& stamps,
                                                          const pybind11::object& poses);

/// Returns a colour image (blue, green, red) or grey image that was given as uint8 of shape
/// (H, W, 3), red first, or (H, W). Grey images, and colour images that are a view of one with blue
/// first, share the memory of the array; others are copied.
[[nodiscard]] cv::Mat color_image_from(const pybind11::array& array);
/// Returns a depth image that was given as uint16 of shape (H, W); shares its memory if its rows
/// are contiguous.
[[nodiscard]] cv::Mat depth_image_from(const pybind11::array& array);

/// Gives notes to the caller as UserWarnings.
void warn(const std::vector<std::string>& notes);

/// Returns a view of an image that can only be read; it keeps the image alive. Colours have red
/// first. None for an image without pixels.
[[nodiscard]] pybind11::object view_of(const cv::Mat& image);

}  // namespace cvo_slam::python
