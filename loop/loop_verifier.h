// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/loop/orb_features.h"
#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {

/// How features of two images are matched.
struct MatchingOptions {
  /// Features are compared if they share the node of the vocabulary this many levels below the
  /// root, 0 to 16; 0 = all with all.
  int node_level = 1;
  int max_distance = 64;  ///< largest distance between the descriptors of a match [bits], 0 to 256
  /// Largest ratio of the distances to the nearest and to the second nearest descriptor, 0 to 1.
  double ratio = 0.85;
  /// Largest difference between the rotation of a match and the most common one [rad], 0 to 3.15.
  double rotation_window = 0.35;
  /// Radius of the search for a feature around its projection [px at the finest pyramid level],
  /// 0 to 1000.
  double search_radius = 8;
};

/// How a candidate is verified.
struct VerificationOptions {
  MatchingOptions matching;  ///< how features are matched
  int min_matches = 12;      ///< least number of matches for a pose to be searched, 3 to 100000
  int iterations = 500;      ///< most triples of matches that are tried, 1 to 1000000
  /// Largest distance between a feature and the projection of its match, for an inlier [px at the
  /// finest pyramid level], 0.1 to 100. Three standard deviations of an ORB feature. Raise it for a
  /// camera with a poor calibration.
  double max_reprojection = 3;
  /// Least number of inliers of an accepted candidate, 4 to 100000. Lower it to close loops with
  /// few common features; raise it where different places look alike.
  int min_inliers = 25;
  double min_visible_share = 0.1;  ///< least Verification::inlier_share, 0 to 1
  /// Least Verification::coverage, 0 to 1; below it, the common features may be a single object.
  double min_coverage = 0.4;
  /// Largest standard deviation of the position in any direction [m], 0 to 100.
  double max_deviation_translation = 0.02;
  /// Largest standard deviation of the orientation about any axis [rad], 0 to 4.
  double max_deviation_rotation = 0.015;
};

/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(VerificationOptions& options);

/// The features and visual words of an image.
struct Appearance {
  std::size_t id = 0;    ///< chosen by the owner, e.g. the index of the frame
  OrbFeatures features;  ///< corners with descriptors
  ImageWords words;      ///< visual words, and nodes at MatchingOptions::node_level
};

/// The pixels at which two images see the same point [px].
struct PixelPair {
  float a_u = 0;  ///< column in image a
  float a_v = 0;  ///< row in image a
  float b_u = 0;  ///< column in image b
  float b_v = 0;  ///< row in image b
};

/// The result of comparing two images: whether they show the same place, and the relative pose.
struct Verification {
  bool accepted = false;  ///< true if both images show the same place
  std::string reason;     ///< why the pair was rejected; empty if it was accepted
  SE3 T_a_b;  ///< pose of camera b in the frame of camera a; to be used only if accepted
  Matrix6 information = Matrix6::Zero();  ///< of a right perturbation of T_a_b
  std::size_t matches = 0;                ///< matches by words with a common rotation
  std::size_t inliers = 0;                ///< among the features matched with the known pose
  double inlier_share = 0;                ///< inliers over the features that both images should see
  /// Share of the image cells in which features should be seen that have an inlier, in the worse of
  /// the two images. An object that is in two places, such as a poster, explains its own cells
  /// only.
  double coverage = 0;
  std::vector<PixelPair> pixels;  ///< the inliers; for a rejected pair, those of the best pose
};

/// Compares two images of a calibrated RGB-D camera by their features. The result depends only on
/// the two images, the options and the two ids, which seed the search.
class LoopVerifier {
 public:
  /// Throws OptionError for a bad option or camera.
  explicit LoopVerifier(const Camera& camera, const VerificationOptions& options = {});

  /// Compares two images, whose words must be of the same vocabulary.
  [[nodiscard]] Verification verify(const Appearance& a, const Appearance& b) const;

 private:
  Camera camera_;
  VerificationOptions options_;
};

}  // namespace cvo_slam
