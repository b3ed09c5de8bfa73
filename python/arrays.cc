// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <memory>

#include <Eigen/LU>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/python/arrays_internal.h"

namespace py = pybind11;

namespace cvo_slam::python {
namespace {

std::string shape_of(const py::array& array) {
  std::vector<py::ssize_t> shape(array.shape(), array.shape() + array.ndim());
  return fmt::format("({})", fmt::join(shape, ", "));
}

std::string type_of(const py::array& array) { return py::str(array.dtype()); }

std::string expected_shape(const std::vector<py::ssize_t>& shape) {
  std::vector<std::string> sizes;
  for (const py::ssize_t size : shape) sizes.push_back(size < 0 ? "N" : std::to_string(size));
  return fmt::format("({})", fmt::join(sizes, ", "));
}

bool has_shape(const py::array& array, const std::vector<py::ssize_t>& shape) {
  if (array.ndim() != static_cast<py::ssize_t>(shape.size())) return false;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (shape[i] >= 0 && shape[i] != array.shape(static_cast<py::ssize_t>(i))) return false;
  }
  return true;
}

/// An array for reading that shares the memory of an image.
py::array read_only_view(const cv::Mat& image, const py::dtype& type,
                         const std::vector<py::ssize_t>& shape,
                         const std::vector<py::ssize_t>& strides, const void* first) {
  auto owner = std::make_unique<cv::Mat>(image);
  const py::capsule keep_alive(owner.get(), [](void* mat) {
    const std::unique_ptr<cv::Mat> ends_here(static_cast<cv::Mat*>(mat));
  });
  static_cast<void>(owner.release());
  py::array array(type, shape, strides, first, keep_alive);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// The rows of a numpy array as an image that shares its memory.
cv::Mat shared_image(const py::array& array, int type, const void* first) {
  // cv::Mat has no constant data; what tracks a frame only reads it.
  return {static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)), type,
          const_cast<void*>(first), static_cast<std::size_t>(array.strides(0))};
}

bool has_rows_in_order(const py::array& array) {
  return array.strides(0) >= array.shape(1) * array.itemsize();
}

constexpr double kLargestStamp = 4e9;  // [s]; Timestamp::parse() accepts no more

}  // namespace

Doubles doubles_from(const py::object& object, const std::vector<py::ssize_t>& shape,
                     const std::string& name) {
  const auto array = py::array::ensure(object);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(
        fmt::format("{}: expected an array of numbers of shape {}", name, expected_shape(shape)));
  }
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    throw py::type_error(
        fmt::format("{}: expected numbers, got elements of type {}", name, type_of(array)));
  }
  if (!has_shape(array, shape)) {
    throw py::value_error(fmt::format("{}: expected an array of shape {}, got {}", name,
                                      expected_shape(shape), shape_of(array)));
  }
  return Doubles::ensure(array);
}

SE3 pose_from(const double* values, const std::string& name) {
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) matrix(row, column) = values[4 * row + column];
  }
  constexpr double kTolerance = 1e-4;
  const Matrix3 rotation = matrix.topLeftCorner<3, 3>();
  const bool is_rigid =
      matrix.allFinite() && (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < kTolerance &&
      (rotation.transpose() * rotation - Matrix3::Identity()).norm() < kTolerance &&
      rotation.determinant() > 0;
  if (!is_rigid) {
    throw py::value_error(name +
                          ": expected a rigid motion, a 4x4 matrix [R t; 0 0 0 1] with a rotation "
                          "R (R^T R = 1, det R = 1)");
  }
  return SE3::from_matrix(matrix);
}

SE3 pose_from(const py::object& object, const std::string& name) {
  return pose_from(doubles_from(object, {4, 4}, name).data(), name);
}

Matrix6 matrix6_from(const py::object& object, const std::string& name) {
  const Doubles array = doubles_from(object, {6, 6}, name);
  Matrix6 matrix;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) matrix(row, column) = array.at(row, column);
  }
  return matrix;
}

namespace {

void write_matrix(const SE3& pose, double* values) {
  const Eigen::Matrix4d matrix = pose.matrix();
  for (int i = 0; i < 16; ++i) values[i] = matrix(i / 4, i % 4);
}

}  // namespace

Doubles to_array(const SE3& pose) {
  Doubles array({4, 4});
  write_matrix(pose, array.mutable_data());
  return array;
}

Doubles to_array(const Matrix6& matrix) {
  Doubles array({6, 6});
  for (int i = 0; i < 36; ++i) array.mutable_data()[i] = matrix(i / 6, i % 6);
  return array;
}

Doubles to_array(const Vector3& vector) {
  Doubles array(3);
  std::copy_n(vector.data(), 3, array.mutable_data());
  return array;
}

Doubles to_array(const std::vector<StampedPose>& poses) {
  Doubles array({static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}, py::ssize_t{4}});
  double* values = array.mutable_data();
  for (const StampedPose& pose : poses) {
    write_matrix(pose.T_world_camera, values);
    values += 16;
  }
  return array;
}

Doubles stamps_of(const std::vector<StampedPose>& poses) {
  Doubles array(static_cast<py::ssize_t>(poses.size()));
  std::transform(poses.begin(), poses.end(), array.mutable_data(),
                 [](const StampedPose& pose) { return seconds_of(pose.stamp); });
  return array;
}

Timestamp stamp_from(double seconds, const std::string& name) {
  if (!std::isfinite(seconds))
    throw py::value_error(name + ": expected seconds, got " + fmt::format("{}", seconds));
  if (std::fabs(seconds) > kLargestStamp) {
    throw py::value_error(fmt::format(
        "{}: {} is beyond {} s; stamps are in seconds: are these milli- or nanoseconds?", name,
        seconds, kLargestStamp));
  }
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), seconds).ptr;
  const auto parsed = Timestamp::parse(std::string_view(text.data(), end));
  const Timestamp stamp = parsed ? *parsed : Timestamp::from_seconds(seconds);
  const std::string written = stamp.to_string();
  const std::size_t point = written.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : written.size() - point - 1;
  return Timestamp(stamp.nanoseconds(), std::max(6, static_cast<int>(decimals)));
}

std::vector<StampedPose> stamped_poses_from(const py::object& stamps, const py::object& poses) {
  const Doubles seconds = doubles_from(stamps, {-1}, "stamps");
  const Doubles matrices = doubles_from(poses, {-1, 4, 4}, "poses");
  if (seconds.shape(0) != matrices.shape(0)) {
    throw py::value_error(
        fmt::format("there are {} stamps and {} poses", seconds.shape(0), matrices.shape(0)));
  }
  std::vector<StampedPose> result;
  for (py::ssize_t i = 0; i < seconds.shape(0); ++i) {
    const StampedPose pose{stamp_from(seconds.at(i), fmt::format("stamps[{}]", i)),
                           pose_from(matrices.data() + 16 * i, fmt::format("poses[{}]", i))};
    if (!result.empty() && pose.stamp <= result.back().stamp) {
      throw py::value_error(fmt::format("stamps[{}] is not after the stamp before it", i));
    }
    result.push_back(pose);
  }
  return result;
}

cv::Mat color_image_from(const py::array& array) {
  const bool is_grey = array.ndim() == 2;
  if (!is_grey && !(array.ndim() == 3 && array.shape(2) == 3)) {
    throw py::value_error(
        fmt::format("rgb: expected an image of shape (H, W, 3), red first, or (H, W); got {}",
                    shape_of(array)));
  }
  if (!py::isinstance<py::array_t<std::uint8_t>>(array)) {
    throw py::type_error("rgb: expected uint8, got " + type_of(array));
  }
  if (array.size() == 0) return {};
  const auto* first = static_cast<const std::uint8_t*>(array.data());
  if (is_grey) {
    if (array.strides(1) == 1 && has_rows_in_order(array)) {
      return shared_image(array, CV_8UC1, first);
    }
    const auto whole = py::array_t<std::uint8_t, py::array::c_style>::ensure(array);
    return shared_image(whole, CV_8UC1, whole.data()).clone();
  }
  if (array.strides(2) == -1 && array.strides(1) == 3 && has_rows_in_order(array)) {
    return shared_image(array, CV_8UC3, first - 2);  // blue is before green is before red
  }
  cv::Mat bgr;
  if (array.strides(2) == 1 && array.strides(1) == 3 && has_rows_in_order(array)) {
    cv::cvtColor(shared_image(array, CV_8UC3, first), bgr, cv::COLOR_RGB2BGR);
  } else {
    const auto whole = py::array_t<std::uint8_t, py::array::c_style>::ensure(array);
    cv::cvtColor(shared_image(whole, CV_8UC3, whole.data()), bgr, cv::COLOR_RGB2BGR);
  }
  return bgr;
}

cv::Mat depth_image_from(const py::array& array) {
  if (array.ndim() != 2) {
    throw py::value_error("depth: expected an image of shape (H, W), got " + shape_of(array));
  }
  if (!py::isinstance<py::array_t<std::uint16_t>>(array)) {
    throw py::type_error("depth: expected uint16, Camera.depth_scale units a metre, got " +
                         type_of(array) +
                         "; of metres, make (depth * camera.depth_scale).astype(numpy.uint16)");
  }
  if (array.size() == 0) return {};
  if (array.strides(1) == 2 && has_rows_in_order(array)) {
    return shared_image(array, CV_16UC1, array.data());
  }
  const auto whole = py::array_t<std::uint16_t, py::array::c_style>::ensure(array);
  return shared_image(whole, CV_16UC1, whole.data()).clone();
}

void warn(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) throw py::error_already_set();
  }
}

py::object view_of(const cv::Mat& image) {
  if (image.empty()) return py::none();
  const auto row = static_cast<py::ssize_t>(image.step[0]);
  const py::ssize_t height = image.rows;
  const py::ssize_t width = image.cols;
  switch (image.type()) {
    case CV_8UC3:
      return read_only_view(image, py::dtype::of<std::uint8_t>(), {height, width, 3}, {row, 3, -1},
                            image.data + 2);
    case CV_8UC1:
      return read_only_view(image, py::dtype::of<std::uint8_t>(), {height, width}, {row, 1},
                            image.data);
    case CV_16UC1:
      return read_only_view(image, py::dtype::of<std::uint16_t>(), {height, width}, {row, 2},
                            image.data);
    default:
      return py::none();
  }
}

}  // namespace cvo_slam::python
