// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/loop/descriptor.h"

namespace cvo_slam {

/// How ORB features are extracted.
struct OrbOptions {
  /// Most features of an image, 10 to 20000. More make loops under changed viewpoints more likely
  /// and take more time and memory (64 bytes per feature of a keyframe).
  int features = 1000;
  int levels = 8;      ///< number of levels of the image pyramid, 1 to 16
  double scale = 1.2;  ///< ratio of the sizes of two neighbouring levels, 1.05 to 2
  /// Least contrast of a corner, between its ring and its centre [grey levels], 1 to 255.
  int threshold = 20;
  /// The same for cells in which `threshold` finds no corner, as on plain walls [grey levels],
  /// 1 to 255.
  int low_threshold = 7;
  int per_cell = 4;  ///< features in each cell of the grids that spread them, 1 to 1000
};

/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(OrbOptions& options);

/// A feature of an image: an oriented corner.
struct OrbFeature {
  float u = 0;      ///< column in the image [px]
  float v = 0;      ///< row in the image [px]
  float x = 0;      ///< x of the ray (x, y, 1) in the camera frame, distortion removed
  float y = 0;      ///< y of that ray
  float depth = 0;  ///< along z [m]; 0 = unknown
  float angle = 0;  ///< orientation, clockwise from the image's x axis [rad], in [0, 2 pi)
  float size = 1;   ///< pixels of the image per pixel of its pyramid level

  /// Returns true if the depth is known.
  [[nodiscard]] bool has_depth() const { return depth > 0; }
  /// Returns the position in the camera frame [m] of a feature with depth.
  [[nodiscard]] Vector3 position() const { return static_cast<double>(depth) * ray(); }
  /// Returns the ray (x, y, 1) through the feature, in the camera frame.
  [[nodiscard]] Vector3 ray() const { return {x, y, 1}; }
};

/// The features of an image; both lists have the same size.
struct OrbFeatures {
  std::vector<OrbFeature> points;       ///< where they are
  std::vector<Descriptor> descriptors;  ///< what they look like

  /// Returns the number of features.
  [[nodiscard]] std::size_t size() const { return points.size(); }
  /// Returns true if there are no features.
  [[nodiscard]] bool empty() const { return points.empty(); }
};

/// Returns oriented FAST corners with their ORB descriptors (E. Rublee et al., "ORB: an efficient
/// alternative to SIFT or SURF", ICCV 2011; OpenCV's implementation). The strongest corner of each
/// cell of a grid is taken in turn, so that they are spread evenly over the image. Cells without
/// any corner are searched again with a lower threshold.
///
/// An image that is empty, too small or neither CV_8UC3 nor CV_8UC1 has no features. No feature has
/// a depth if the depth image is missing or of another size or type. A feature whose neighbours are
/// at very different depths has none either, because it may belong to either side of the edge.
[[nodiscard]] OrbFeatures extract_orb(const RgbdFrame& frame, const Camera& camera,
                                      const OrbOptions& options = {});

}  // namespace cvo_slam
