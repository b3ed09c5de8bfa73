// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
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
  /// and take more time and memory (85 bytes per feature of a keyframe).
  int features = 1000;
  int levels = 8;
  double scale = 1.2;
  int threshold = 20;
  int low_threshold = 7;
  int per_cell = 4;
};

[[nodiscard]] OptionSet describe(OrbOptions& options);

/// A feature of an image: an oriented corner.
struct OrbFeature {
  float u = 0;  ///< position in the image [px]
  float v = 0;
  float x = 0;  ///< ray (x, y, 1) in the camera frame, distortion removed
  float y = 0;
  float depth = 0;  ///< along z [m]; 0 = unknown
  float angle = 0;  ///< orientation, clockwise from the image's x axis [rad], in [0, 2 pi)
  float size = 1;   ///< pixels of the image per pixel of its pyramid level

  [[nodiscard]] bool has_depth() const { return depth > 0; }
  /// Returns the position in the camera frame [m] of a feature with depth.
  [[nodiscard]] Vector3 position() const { return static_cast<double>(depth) * ray(); }
  [[nodiscard]] Vector3 ray() const { return {x, y, 1}; }
};

/// The features of an image; both lists have the same size.
struct OrbFeatures {
  std::vector<OrbFeature> points;
  std::vector<Descriptor> descriptors;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] bool empty() const { return points.empty(); }
};

/// Returns the features of a keyframe as bytes for map files, 45 a feature: positions are rounded
/// to 1/16 px and orientations to 1.4 degrees, which is below what the corners are accurate to.
[[nodiscard]] std::string features_to_bytes(const OrbFeatures& features);
/// Returns the features of features_to_bytes(). Throws DataError if the bytes are not those of
/// features.
[[nodiscard]] OrbFeatures features_from_bytes(std::string_view bytes, const PinholeCamera& camera);

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
