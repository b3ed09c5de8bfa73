// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/opencv_odometry.h"

#ifdef CVO_SLAM_HAS_OPENCV_RGBD

#include <limits>
#include <utility>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/rgbd.hpp>

#include "cvo_slam/frontend/point_selection.h"

namespace cvo_slam {
namespace {

using cv::rgbd::OdometryFrame;

cv::Mat camera_matrix(const PinholeCamera& camera) {
  // NOLINTNEXTLINE(modernize-return-braced-init-list): this is OpenCV's way to fill a matrix.
  return (cv::Mat_<double>(3, 3) << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
}

cv::Ptr<cv::rgbd::Odometry> make_odometry(OpencvMethod method, const PinholeCamera& camera) {
  const cv::Mat K = camera_matrix(camera);
  switch (method) {
    case OpencvMethod::kRgbd:
      return cv::rgbd::RgbdOdometry::create(K);
    case OpencvMethod::kRgbdIcp:
      return cv::rgbd::RgbdICPOdometry::create(K);
    case OpencvMethod::kIcp:
      return cv::rgbd::ICPOdometry::create(K);
  }
  return nullptr;
}

/// Converts a frame to what the odometries of OpenCV expect: grey levels, and depth in metres with
/// NaN for missing values, both without distortion.
class FrameConverter {
 public:
  explicit FrameConverter(const Camera& camera) : depth_scale_(camera.depth_scale) {
    const PinholeCamera& color = camera.color;
    if (!color.has_distortion()) return;
    const cv::Mat K = camera_matrix(color);
    cv::initUndistortRectifyMap(K, color.distortion, cv::noArray(), K, {color.width, color.height},
                                CV_16SC2, map_, map_fraction_);
  }

  [[nodiscard]] cv::Ptr<OdometryFrame> convert(const RgbdFrame& frame) const {
    cv::Mat gray = frame.color;
    if (gray.channels() == 3) cv::cvtColor(frame.color, gray, cv::COLOR_BGR2GRAY);
    cv::Mat depth = frame.depth;
    if (!map_.empty()) {
      cv::remap(cv::Mat(gray), gray, map_, map_fraction_, cv::INTER_LINEAR);
      // Not interpolated: it would invent surfaces between an object and what is behind it.
      cv::remap(cv::Mat(depth), depth, map_, map_fraction_, cv::INTER_NEAREST);
    }
    cv::Mat metres;
    depth.convertTo(metres, CV_32F, 1 / depth_scale_);
    metres.setTo(std::numeric_limits<float>::quiet_NaN(), depth == 0);
    return OdometryFrame::create(gray, metres);
  }

 private:
  double depth_scale_;
  cv::Mat map_;  // empty without distortion
  cv::Mat map_fraction_;
};

SE3 to_se3(const cv::Mat& T) {
  using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  return SE3::from_matrix(Eigen::Map<const RowMajor>(T.ptr<double>()));
}

class OpencvOdometry final : public OdometrySystem {
 public:
  OpencvOdometry(OpencvMethod method, const Camera& camera)
      : camera_(camera), converter_(camera), odometry_(make_odometry(method, camera.color)) {}

  std::optional<SE3> track(const RgbdFrame& frame) override {
    if (!check_images(frame, camera_).empty()) return std::nullopt;
    cv::Ptr<OdometryFrame> current = converter_.convert(frame);
    cv::Ptr<OdometryFrame> previous = std::exchange(previous_, current);
    if (previous) {
      const std::optional<SE3> T_previous_current = compute(current, previous);
      if (!T_previous_current) return std::nullopt;
      T_world_camera_ = T_world_camera_ * *T_previous_current;
    }
    return T_world_camera_;
  }

 private:
  /// The frames keep the pyramids that were computed for them, for the next pair.
  [[nodiscard]] std::optional<SE3> compute(cv::Ptr<OdometryFrame>& current,
                                           cv::Ptr<OdometryFrame>& previous) const {
    try {
      cv::Mat T_previous_current;
      if (!odometry_->compute(current, previous, T_previous_current)) return std::nullopt;
      return to_se3(T_previous_current);
    } catch (const cv::Exception&) {  // an unusable image, e.g. one without any depth
      return std::nullopt;
    }
  }

  Camera camera_;
  FrameConverter converter_;
  cv::Ptr<cv::rgbd::Odometry> odometry_;
  cv::Ptr<OdometryFrame> previous_;
  SE3 T_world_camera_;
};

}  // namespace

std::unique_ptr<OdometrySystem> make_opencv_odometry(OpencvMethod method, const Camera& camera) {
  return std::make_unique<OpencvOdometry>(method, camera);
}

}  // namespace cvo_slam

#else

namespace cvo_slam {

std::unique_ptr<OdometrySystem> make_opencv_odometry(OpencvMethod /*method*/,
                                                     const Camera& /*camera*/) {
  return nullptr;
}

}  // namespace cvo_slam

#endif
