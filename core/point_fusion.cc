// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

#include "cvo_slam/core/map.h"
#include "cvo_slam/core/voxel_grid_internal.h"

namespace cvo_slam {
namespace {

/// The piece of surface that a pixel shows, in the camera frame.
struct Sample {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;
  std::array<std::uint8_t, 3> color;  // red, green, blue
};

/// The directions (x/z, y/z, 1) of the pixels of sampled frames, which are mostly of one size.
class Rays {
 public:
  Rays(const SampledFrame& frame, const PinholeCamera& camera)
      : size_(frame.depth.size()), pixel_step_(frame.pixel_step) {
    rays_.reserve(frame.depth.total());
    for (int v = 0; v < size_.height; ++v) {
      for (int u = 0; u < size_.width; ++u) {
        const Eigen::Vector2d pixel(u * pixel_step_ + pixel_step_ / 2,
                                    v * pixel_step_ + pixel_step_ / 2);
        rays_.emplace_back(camera.unproject(pixel).cast<float>());
      }
    }
  }

  [[nodiscard]] bool are_of(const SampledFrame& frame) const {
    return frame.depth.size() == size_ && frame.pixel_step == pixel_step_;
  }
  [[nodiscard]] const Eigen::Vector3f& operator()(int u, int v) const {
    return rays_[static_cast<std::size_t>(v) * static_cast<std::size_t>(size_.width) +
                 static_cast<std::size_t>(u)];
  }

 private:
  cv::Size size_;
  int pixel_step_;
  std::vector<Eigen::Vector3f> rays_;
};

/// The surface points of a sampled depth image.
class DepthSurface {
 public:
  DepthSurface(const SampledFrame& frame, const Rays& ray, const Camera& camera,
               const FusionOptions& options)
      : frame_(frame),
        ray_(ray),
        options_(options),
        metres_(static_cast<float>(1 / camera.depth_scale)),
        max_depth_(static_cast<float>(options.max_depth)) {}

  [[nodiscard]] std::vector<Sample> samples() const {
    std::vector<Sample> result;
    for (int v = 0; v < frame_.depth.rows; ++v) {
      for (int u = 0; u < frame_.depth.cols; ++u) {
        Sample sample;
        if (!make_sample(u, v, sample)) continue;
        result.push_back(sample);
      }
    }
    return result;
  }

 private:
  /// Returns the depth of a pixel [m]; 0 if it has none or lies outside the image.
  [[nodiscard]] float depth(int u, int v) const {
    const bool inside = u >= 0 && v >= 0 && u < frame_.depth.cols && v < frame_.depth.rows;
    return inside ? metres_ * static_cast<float>(frame_.depth.at<std::uint16_t>(v, u)) : 0;
  }

  /// Computes the surface's direction from the neighbour on one side of a pixel to the neighbour on
  /// the other side. A neighbour without depth or beyond a jump is replaced by the pixel itself.
  /// Returns false if neither neighbour can be used.
  bool tangent(int u, int v, float z, int du, int dv, Eigen::Vector3f& direction) const {
    const float before = depth(u - du, v - dv);
    const float after = depth(u + du, v + dv);
    const float limit = static_cast<float>(options_.max_jump) * z;
    const bool has_before = before > 0 && std::fabs(before - z) < limit;
    const bool has_after = after > 0 && std::fabs(after - z) < limit;
    if (!has_before && !has_after) return false;
    const Eigen::Vector3f from = has_before ? before * ray_(u - du, v - dv) : z * ray_(u, v);
    const Eigen::Vector3f to = has_after ? after * ray_(u + du, v + dv) : z * ray_(u, v);
    direction = to - from;
    return true;
  }

  bool make_sample(int u, int v, Sample& sample) const {
    const float z = depth(u, v);
    if (!(z > 0 && z <= max_depth_)) return false;
    Eigen::Vector3f along_u;
    Eigen::Vector3f along_v;
    if (!tangent(u, v, z, 1, 0, along_u) || !tangent(u, v, z, 0, 1, along_v)) return false;
    sample.position = z * ray_(u, v);
    sample.normal = along_u.cross(along_v).normalized();
    if (sample.normal.dot(sample.position) > 0) sample.normal = -sample.normal;
    const float cosine = -sample.normal.dot(sample.position) / sample.position.norm();
    if (!(cosine >= static_cast<float>(options_.min_cosine))) return false;
    sample.color = color(u, v);
    return true;
  }

  [[nodiscard]] std::array<std::uint8_t, 3> color(int u, int v) const {
    if (frame_.color.channels() == 1) {
      const auto grey = frame_.color.at<std::uint8_t>(v, u);
      return {grey, grey, grey};
    }
    const auto& bgr = frame_.color.at<cv::Vec3b>(v, u);
    return {bgr[2], bgr[1], bgr[0]};
  }

  const SampledFrame& frame_;
  const Rays& ray_;
  const FusionOptions& options_;
  float metres_;
  float max_depth_;
};

bool is_usable(const PosedFrame& posed) {
  const SampledFrame& frame = posed.frame;
  return !frame.depth.empty() && frame.depth.type() == CV_16UC1 &&
         frame.color.size() == frame.depth.size() && frame.color.depth() == CV_8U &&
         (frame.color.channels() == 1 || frame.color.channels() == 3) &&
         posed.T_world_camera.matrix().allFinite();
}

std::vector<Sample> samples_in_camera(const PosedFrame& posed, const Rays& usual_rays,
                                      const Camera& camera, const FusionOptions& options) {
  if (!is_usable(posed)) return {};
  const SampledFrame& frame = posed.frame;
  if (usual_rays.are_of(frame)) return DepthSurface(frame, usual_rays, camera, options).samples();
  return DepthSurface(frame, Rays(frame, camera.color), camera, options).samples();
}

/// Returns the weight of a depth z: its inverse variance, or 1 if the sensor has no noise.
float weight_of(double z, const SensorNoise& noise) {
  const double sigma = noise.sigma_z(z);
  return sigma > 0 ? static_cast<float>(1 / (sigma * sigma)) : 1;
}

void add_to(VoxelGrid& grid, const std::vector<Sample>& samples, const SE3& T_world_camera,
            const SensorNoise& noise) {
  const Eigen::Matrix3f R = T_world_camera.rotation().cast<float>();
  for (const Sample& sample : samples) {
    grid.add(T_world_camera * sample.position.cast<double>(), R * sample.normal, sample.color,
             weight_of(sample.position.z(), noise));
  }
}

}  // namespace

OptionSet describe(FusionOptions& o) {
  return OptionSet()
      .add(
          "voxel_size", o.voxel_size, {1e-3, 10}, "m",
          "Edge length of the voxels, each of which leaves one point of the map. 2 cm is the depth "
          "noise of a Kinect at 3 m.")
      .add("max_depth", o.max_depth, {0.1, 1000}, "m",
           "Pixels with a larger depth are left out of the map. A Kinect's depth has steps of 3 cm "
           "at 4 m.")
      .expert()
      .add("pixel_step", o.pixel_step, {1, 64}, "px",
           "Step between the pixels of a keyframe that become points, along rows and columns.")
      .add("min_samples", o.min_samples, {1, 1000}, "",
           "Least number of pixels that must have seen a voxel; with fewer it leaves no point.")
      .add("max_jump", o.max_jump, {1e-3, 1}, "",
           "Neighbouring pixels belong to different surfaces if their depths differ by more than "
           "this share of the depth.")
      .add("min_cosine", o.min_cosine, {0, 1}, "",
           "Least cosine of the angle between the viewing ray and the normal; surfaces seen at a "
           "more grazing angle are left out.");
}

SampledFrame sample_frame(const RgbdFrame& frame, int pixel_step) {
  SampledFrame result{frame.stamp, pixel_step, {}, {}};
  if (frame.depth.empty() || frame.color.size() != frame.depth.size()) return result;
  const int rows = (frame.depth.rows + pixel_step - 1 - pixel_step / 2) / pixel_step;
  const int columns = (frame.depth.cols + pixel_step - 1 - pixel_step / 2) / pixel_step;
  result.color.create(rows, columns, frame.color.type());
  result.depth.create(rows, columns, frame.depth.type());
  const auto copy_pixels = [&](const cv::Mat& from, cv::Mat& to, int v) {
    const std::size_t bytes = from.elemSize();
    const std::uint8_t* source = from.ptr(pixel_step * v + pixel_step / 2);
    for (int u = 0; u < columns; ++u) {
      const int column = pixel_step * u + pixel_step / 2;
      std::copy_n(source + bytes * static_cast<std::size_t>(column), bytes, to.ptr(v, u));
    }
  };
  for (int v = 0; v < rows; ++v) {
    copy_pixels(frame.color, result.color, v);
    copy_pixels(frame.depth, result.depth, v);
  }
  return result;
}

std::vector<MapPoint> fuse_points(std::span<const PosedFrame> frames, const Camera& camera,
                                  const FusionOptions& options, const Executor& executor) {
  camera.check();
  FusionOptions checked = options;
  describe(checked).check();
  // A batch is computed in parallel and added in order; a fixed size bounds the memory.
  constexpr std::size_t kBatch = 16;
  VoxelGrid grid(options.voxel_size);
  const Rays rays(frames.empty() ? SampledFrame() : frames.front().frame, camera.color);
  std::array<std::vector<Sample>, kBatch> samples;
  for (std::size_t begin = 0; begin < frames.size(); begin += kBatch) {
    const auto batch = frames.subspan(begin, std::min(kBatch, frames.size() - begin));
    executor.for_each_chunk(batch.size(), 1, [&](std::size_t, std::size_t i, std::size_t) {
      samples[i] = samples_in_camera(batch[i], rays, camera, options);
    });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      add_to(grid, samples[i], batch[i].T_world_camera, camera.noise);
    }
  }
  return grid.points(options.min_samples);
}

}  // namespace cvo_slam
