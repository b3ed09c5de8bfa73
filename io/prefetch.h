// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <future>

#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// Reads the frames of a range one after the other and decodes the next few meanwhile, each on a
/// thread of its own. What next() returns is what Dataset::read() would, in the same order.
class FramePrefetcher {
 public:
  /// Of the frames begin, begin + step, ... below end, with `ahead` >= 1 of them being read at a
  /// time. `data` must outlive the object.
  FramePrefetcher(const Dataset& data, std::size_t begin, std::size_t end, std::size_t step = 1,
                  std::size_t ahead = 2);

  [[nodiscard]] bool done() const { return reading_.empty(); }
  /// The next frame; must not be called when done(). Throws what Dataset::read() throws.
  [[nodiscard]] RgbdFrame next();

 private:
  void start_one();

  const Dataset& data_;
  std::size_t next_;
  std::size_t end_;
  std::size_t step_;
  std::deque<std::future<RgbdFrame>> reading_;  // their destructors wait for the threads
};

}  // namespace cvo_slam
