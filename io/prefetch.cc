// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/prefetch.h"

#include <utility>

namespace cvo_slam {

FramePrefetcher::FramePrefetcher(const Dataset& data, std::size_t begin, std::size_t end,
                                 std::size_t step, std::size_t ahead)
    : data_(data), next_(begin), end_(end), step_(step) {
  for (std::size_t i = 0; i < ahead; ++i) start_one();
}

RgbdFrame FramePrefetcher::next() {
  std::future<RgbdFrame> frame = std::move(reading_.front());
  reading_.pop_front();
  start_one();
  return frame.get();
}

void FramePrefetcher::start_one() {
  if (next_ >= end_) return;
  reading_.push_back(
      std::async(std::launch::async, [this, index = next_] { return data_.read(index); }));
  next_ += step_;
}

}  // namespace cvo_slam
