// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cvo_slam {

/// Turns SIGINT into a question for as long as it lives, so that a run can end early and still
/// write what there is. A second SIGINT ends the program at once. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] static bool requested();

 private:
  void (*previous_)(int);
};

}  // namespace cvo_slam
