// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/loop/bag_of_words.h"
#include "cvo_slam/loop/loop_options.h"
#include "cvo_slam/loop/orb_features.h"

namespace cvo_slam {

/// What the loop detector knows of an image.
struct Appearance {
  std::size_t id = 0;  ///< whatever its owner calls it, e.g. the index of the frame
  OrbFeatures features;
  ImageWords words;
};

/// Where two images see the same point [px].
struct PixelPair {
  float a_u = 0;
  float a_v = 0;
  float b_u = 0;
  float b_v = 0;
};

/// Whether two images show the same place, and from where.
struct Verification {
  bool accepted = false;
  std::string reason;  ///< why it was not accepted; empty where it was
  SE3 T_a_b;
  Matrix6 information = Matrix6::Zero();  ///< of a right perturbation of T_a_b
  std::size_t matches = 0;                ///< of words, with a common rotation
  std::size_t inliers = 0;                ///< of the features matched with the pose known
  double visible_share = 0;  ///< inliers among the features that both images should see
  /// Of the cells of the image where features should be seen in either image, the share with an
  /// inlier. A poster that hangs in two places explains its own cells alone.
  double coverage = 0;
  std::vector<PixelPair> pixels;  ///< of the inliers; of a rejected pair what agreed best
};

/// Compares two images of a calibrated RGB-D camera by their features. Answers follow from the two
/// images, the options and the two ids (which seed the search) alone.
class LoopVerifier {
 public:
  /// Throws OptionError for a bad option.
  explicit LoopVerifier(const PinholeCamera& camera, const VerificationOptions& options = {});

  [[nodiscard]] Verification verify(const Appearance& a, const Appearance& b) const;

 private:
  PinholeCamera camera_;
  VerificationOptions options_;
};

}  // namespace cvo_slam
