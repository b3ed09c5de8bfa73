// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// How a camera has turned between two images.
struct ImageRotation {
  Matrix3 R_from_to;       ///< orientation of the later camera in the frame of the earlier one
  double correlation = 0;  ///< of the two tiny images where they overlap, at most 1
};

/// Finds how a camera has turned between two images (CV_8UC3 or CV_8UC1 of the camera's size), as
/// if it had not moved otherwise: what one sees moves alike then, whatever its depth is. The images
/// are made so small and blurred, 40 pixels along the longer side, that a fast turn is a few
/// pixels, as in G. Klein and D. Murray, "Improving the Agility of Keyframe-Based SLAM", ECCV 2008,
/// section 3.4. Shifts of up to half the image are tried, and `R_start`; both are refined by
/// Gauss-Newton over SO(3), and the better one is returned. Takes a millisecond. Distortion is
/// neglected.
[[nodiscard]] ImageRotation find_image_rotation(const cv::Mat& from, const cv::Mat& to,
                                                const PinholeCamera& camera,
                                                const Matrix3& R_start);

/// Returns a motion between two images, T_from_to, with the rotation that they show; unchanged if
/// they have too little in common.
[[nodiscard]] SE3 turned_as_seen(const SE3& T_from_to, const cv::Mat& from, const cv::Mat& to,
                                 const PinholeCamera& camera);

}  // namespace cvo_slam
