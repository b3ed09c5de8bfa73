// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/core/parallel.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// A point of a surface.
struct MapPoint {
  /// Relative to the origin of its cloud [m], which is zero unless the cloud says otherwise.
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  /// Unit vector towards the side the point was seen from; zero if it is not known.
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  std::array<std::uint8_t, 3> color = {0, 0, 0};  ///< red, green, blue
};

/// Returns an origin for positions near `place` [m]. A float tells positions a kilometre from zero
/// 0.06 mm apart, but positions in UTM coordinates half a metre: within a kilometre of zero the
/// origin is zero, farther away it is `place` in whole kilometres. It is zero, too, if `place` is
/// not finite or is beyond a million kilometres.
[[nodiscard]] inline Vector3 origin_near(const Vector3& place) {
  constexpr double kNear = 1e3;
  constexpr double kFarthest = 1e9;
  const double farthest = place.cwiseAbs().maxCoeff();
  if (!place.allFinite() || farthest <= kNear || farthest > kFarthest) return Vector3::Zero();
  // + 0.0 makes a negative zero positive.
  return place.unaryExpr([](double value) { return kNear * std::round(value / kNear) + 0.0; });
}

/// What a map remembers of a keyframe so that images can be recognised in it and registered to it.
struct KeyframeMemory {
  std::size_t number = 0;  ///< the id of its node in the graph
  Timestamp stamp;         ///< stamp of its colour image
  int submap = 0;          ///< in which it was tracked; edges may join it with others
  std::string points;      ///< its cloud, as bytes that slam/ makes and reads
  std::string features;    ///< its ORB features, likewise; empty if places are not recognised
};

/// What Slam needs besides the graph to go on from a map.
struct MapMemory {
  Camera camera;                          ///< the camera that the map was made with
  std::vector<KeyframeMemory> keyframes;  ///< in the order of the graph's nodes
  /// Sum of cos_theta over the registrations of consecutive keyframes.
  double cos_theta_sum = 0;
  std::size_t cos_theta_count = 0;  ///< number of registrations in that sum
  /// crc32_of() the bytes of the vocabulary that the map was made with; 0 if none was. Another
  /// one serves too: words are made of the features when the map is read.
  std::uint32_t vocabulary = 0;
  /// All else that Slam needs to go on between the same two frames, as bytes that slam/ makes and
  /// reads; empty in a map that only other frames add to.
  std::string session;
};

/// A map: the poses of the keyframes, the measurements between them, and the surface they saw.
struct Map {
  /// In ascending order of stamps, with `memory` in the order of the graph; none if only the graph
  /// knows them.
  std::vector<StampedPose> keyframes;
  /// Node i is keyframe i and has its pose. Without nodes if nothing but the poses is known.
  PoseGraph graph;
  std::vector<MapPoint> points;  ///< the surface; empty if it was not computed (fuse_points())
  Vector3 points_origin = Vector3::Zero();  ///< added to the points' positions [m]
  /// Empty in a map that only serves pictures.
  std::optional<MapMemory> memory = std::nullopt;
};

/// How the points of a map are computed from frames.
struct FusionOptions {
  int pixel_step = 3;  ///< step between pixels used, along rows and columns [px], 1 to 64
  /// Edge length of the voxels, each of which leaves one point [m], 1 mm to 10 m. 2 cm is the depth
  /// noise of a Kinect at 3 m. Smaller shows more detail of near surfaces and takes more memory;
  /// larger suits wide outdoor scenes.
  double voxel_size = 0.02;
  /// Least number of pixels that must have seen a voxel, 1 to 1000; with fewer it leaves no point.
  int min_samples = 2;
  /// Pixels with a larger depth are left out [m], 0.1 to 1000. A Kinect's depth has steps of 3 cm
  /// at 4 m. Raise it for a sensor that is accurate farther away.
  double max_depth = 4;
  /// Largest difference between the depths of neighbouring pixels on the same surface, as a share
  /// of the depth, 0.001 to 1.
  double max_jump = 0.05;
  /// Least cosine of the angle between viewing ray and normal, 0 to 1. Surfaces seen at a more
  /// grazing angle are left out.
  double min_cosine = 0.15;
};

/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(FusionOptions& options);

/// The pixels of a frame that fusion uses: small enough to be kept for every keyframe until its
/// pose is final.
struct SampledFrame {
  Timestamp stamp;     ///< stamp of the colour image
  int pixel_step = 1;  ///< pixel (u, v) here is pixel step * (u, v) + step / 2 of the frame
  cv::Mat color;       ///< as RgbdFrame::color
  cv::Mat depth;       ///< as RgbdFrame::depth
};

/// Returns every `pixel_step`-th pixel of every `pixel_step`-th row; without images if the frame
/// has none, or has images of different sizes.
[[nodiscard]] SampledFrame sample_frame(const RgbdFrame& frame, int pixel_step);

/// A sampled frame and its pose.
struct PosedFrame {
  SampledFrame frame;  ///< its pixels
  SE3 T_world_camera;  ///< pose in the world that the points are for
};

/// Returns the surface that the frames saw: for each voxel the mean of the points in it, weighted
/// by 1 / sigma_z^2 of the camera's noise model. Normals are computed from the depth images and
/// point to the camera. Pixels at the rim of a surface, surfaces seen at a grazing angle, and
/// frames without images or with a pose that is not finite are left out. Points are in the order in
/// which their voxels were met, whatever the number of threads. Positions are floats: poses far
/// from zero should be made relative to an origin (origin_near()). What is more than 2^20 voxels
/// from zero along an axis is left out. Throws OptionError if the camera or an option is
/// impossible.
[[nodiscard]] std::vector<MapPoint> fuse_points(std::span<const PosedFrame> frames,
                                                const Camera& camera,
                                                const FusionOptions& options = {},
                                                const Executor& executor = Executor(1));

}  // namespace cvo_slam
