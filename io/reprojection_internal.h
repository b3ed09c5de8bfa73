// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/io/camera_check.h"

namespace cvo_slam {

/// Longest gap of a reference to interpolate over [s], as in evaluation.
inline constexpr double kMaxPoseGap = 0.1;

/// A frame of a recording and its pose.
struct LocatedFrame {
  std::size_t index = 0;
  SE3 T_world_camera;
};

struct FramePairMotion {
  LocatedFrame a;
  LocatedFrame b;
};

/// Returns the frames whose stamp has a pose.
[[nodiscard]] std::vector<LocatedFrame> posed_frames(const std::vector<Timestamp>& stamps,
                                                     const std::vector<StampedPose>& poses);

/// Returns a few pairs spread over the frames, each as far apart as its images overlap well.
[[nodiscard]] std::vector<FramePairMotion> choose_pairs(const std::vector<LocatedFrame>& frames);

/// The images of a pair: grey (CV_8UC1), and depth registered to it (CV_16UC1).
struct GreyDepth {
  cv::Mat grey;
  cv::Mat depth;
};

/// Returns the agreement of one pair; empty if too few pixels of `b` lie on the image of `a`.
[[nodiscard]] std::optional<Reprojection> reproject(const GreyDepth& a, const GreyDepth& b,
                                                    const SE3& T_a_b, const Camera& camera);

/// Returns the medians over pairs; empty if there is none.
[[nodiscard]] std::optional<Reprojection> median_of(const std::vector<Reprojection>& pairs);

/// Converts a colour image as readers return it to grey.
[[nodiscard]] cv::Mat to_grey(const cv::Mat& color);

}  // namespace cvo_slam
