// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/saved_state.h"

#include <cstdint>

#include "cvo_slam/core/error.h"

namespace cvo_slam {

void SavedState::expect_end() const {
  if (next_ != bytes_.size()) throw DataError("a saved state has more bytes than it should have");
}

void SavedState::transfer_bytes(void* data, std::size_t size) {
  if (!is_reading_) {
    bytes_.append(static_cast<const char*>(data), size);
    return;
  }
  if (size > bytes_.size() - next_) throw DataError("a saved state is cut off");
  if (size > 0) std::memcpy(data, bytes_.data() + next_, size);
  next_ += size;
}

std::size_t SavedState::transfer_size(std::size_t size) {
  auto count = static_cast<std::uint64_t>(size);
  transfer_bytes(&count, sizeof(count));
  if (is_reading_ && count > bytes_.size() - next_) throw DataError("a saved state is cut off");
  return count;
}

void SavedState::transfer(bool& value) {
  auto byte = static_cast<std::uint8_t>(value ? 1 : 0);
  transfer_bytes(&byte, 1);
  value = byte != 0;
}

void SavedState::transfer(std::string& text) {
  text.resize(transfer_size(text.size()));
  transfer_bytes(text.data(), text.size());
}

void SavedState::transfer(Timestamp& stamp) {
  std::int64_t nanoseconds = stamp.nanoseconds();
  int decimals = stamp.decimals();
  (*this)(nanoseconds, decimals);
  if (decimals < 0 || decimals > Timestamp::kMaxDecimals) {
    throw DataError("a saved state has a stamp with an impossible number of decimals");
  }
  stamp = Timestamp(nanoseconds, decimals);
}

void SavedState::transfer(SE3& pose) {
  Matrix3 rotation = pose.rotation();
  Vector3 translation = pose.translation();
  (*this)(rotation, translation);
  pose = SE3(rotation, translation);
}

void SavedState::transfer(cv::Mat& image) {
  int rows = image.rows;
  int columns = image.cols;
  int type = image.type();
  (*this)(rows, columns, type);
  if (is_reading_) {
    constexpr int kLargest = 1 << 16;
    constexpr int kLargestType = 1 << 8;
    const bool is_possible = rows >= 0 && rows <= kLargest && columns >= 0 && columns <= kLargest &&
                             type >= 0 && type < kLargestType;
    const auto pixels = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    if (!is_possible || pixels > bytes_.size() - next_) {
      throw DataError("a saved state has an impossible image");
    }
    image.release();
    if (pixels > 0) image.create(rows, columns, type);
  }
  const std::size_t row_size = static_cast<std::size_t>(image.cols) * image.elemSize();
  for (int row = 0; row < image.rows; ++row) transfer_bytes(image.ptr(row), row_size);
}

void SavedState::transfer(RgbdFrame& frame) {
  (*this)(frame.index, frame.stamp, frame.depth_stamp, frame.color, frame.depth, frame.problem);
}

}  // namespace cvo_slam
