// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// The state of objects as bytes, so that another object can go on exactly where one was. One
/// function of a class lists what there is for both directions, so that they cannot differ:
///
///     void MotionModel::exchange(SavedState& state) { state(stamp_, T_world_camera_, velocity_); }
///
/// It writes the values into an object that was made without bytes, and replaces them by those of
/// one that was made with them. Bytes are those of this program on this kind of machine.
class SavedState {
 public:
  /// To be written.
  SavedState() = default;
  /// To be read: bytes() of another one.
  explicit SavedState(std::string bytes) : bytes_(std::move(bytes)), is_reading_(true) {}

  [[nodiscard]] bool is_reading() const { return is_reading_; }
  /// What was written.
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  /// Throws DataError unless everything was read.
  void expect_end() const;

  /// Writes the values, or reads them. A value is a number, an enumerator, a string, a type below,
  /// a standard container of values, or an object with a function exchange(SavedState&), as a
  /// member or beside its class. Throws DataError if the bytes are not those of such values.
  template <typename... Values>
  void operator()(Values&... values) {
    (transfer(values), ...);
  }

 private:
  template <typename Value>
  void transfer(Value& value) {
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
      transfer_bytes(&value, sizeof(value));
    } else if constexpr (requires { value.exchange(*this); }) {
      value.exchange(*this);
    } else {
      exchange(*this, value);
    }
  }
  void transfer(bool& value);
  void transfer(std::string& text);
  void transfer(Timestamp& stamp);
  void transfer(SE3& pose);
  void transfer(cv::Mat& image);
  void transfer(RgbdFrame& frame);
  template <typename Scalar, int rows, int columns, int options>
  void transfer(Eigen::Matrix<Scalar, rows, columns, options>& matrix) {
    static_assert(rows != Eigen::Dynamic && columns != Eigen::Dynamic);
    transfer_bytes(matrix.data(), sizeof(Scalar) * static_cast<std::size_t>(matrix.size()));
  }
  template <typename Value>
  void transfer(std::optional<Value>& value) {
    bool has_value = value.has_value();
    transfer(has_value);
    if (is_reading_) {
      value.reset();
      if (has_value) value.emplace();
    }
    if (value) transfer(*value);
  }
  template <typename Value>
  void transfer(std::vector<Value>& values) {
    values.resize(transfer_size(values.size()));
    if constexpr (std::is_arithmetic_v<Value>) {
      transfer_bytes(values.data(), values.size() * sizeof(Value));
    } else {
      for (Value& value : values) transfer(value);
    }
  }
  template <typename Value, std::size_t size>
  void transfer(std::array<Value, size>& values) {
    for (Value& value : values) transfer(value);
  }
  template <typename Value>
  void transfer(std::deque<Value>& values) {
    values.resize(transfer_size(values.size()));
    for (Value& value : values) transfer(value);
  }
  template <typename Key, typename Value>
  void transfer(std::map<Key, Value>& values) {
    std::vector<std::pair<Key, Value>> pairs(values.begin(), values.end());
    transfer(pairs);
    values = std::map<Key, Value>(pairs.begin(), pairs.end());
  }
  template <typename First, typename Second>
  void transfer(std::pair<First, Second>& pair) {
    transfer(pair.first);
    transfer(pair.second);
  }

  void transfer_bytes(void* data, std::size_t size);
  /// Number of values that follow, each of at least a byte.
  std::size_t transfer_size(std::size_t size);

  std::string bytes_;
  std::size_t next_ = 0;
  bool is_reading_ = false;
};

}  // namespace cvo_slam
