// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// Where an image says that the camera is.
struct PlaceGuess {
  Timestamp stamp;
  int part = 0;  ///< of the graph; others have worlds of their own
  SE3 T_world_camera;
};

/// Whether the last frames agree on where the camera is: one that looks like a place is not enough.
class PlaceAgreement {
 public:
  /// So many frames must agree, on a way that a camera of no more than these speeds can go.
  PlaceAgreement(int frames, double max_speed, double max_angular_speed);

  /// Answers whether the guess and those before it are enough. What disagrees with it is forgotten.
  bool see(const PlaceGuess& guess);
  void forget() { guesses_.clear(); }
  /// How many agree now.
  [[nodiscard]] int count() const { return static_cast<int>(guesses_.size()); }

 private:
  [[nodiscard]] bool agree(const PlaceGuess& a, const PlaceGuess& b) const;

  int frames_;
  double max_speed_;
  double max_angular_speed_;
  std::vector<PlaceGuess> guesses_;
};

}  // namespace cvo_slam
