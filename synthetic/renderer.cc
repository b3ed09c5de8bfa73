// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/renderer.h"

#include <opencv2/core.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/picture_internal.h"

namespace cvo_slam::synthetic {

Rendering render(const Scene& scene, const PinholeCamera& camera, const SE3& T_world_camera) {
  camera.check();
  if (camera.has_distortion()) {
    throw OptionError("synthetic camera: distortion is not supported; set it to zero");
  }
  const View view(scene, camera, T_world_camera);
  const Picture picture = draw(camera, [&view](int) -> const View& { return view; }, {});
  Rendering rendering{{}, picture.depth};
  cv::min(picture.color, cv::Scalar::all(255), rendering.color);
  return rendering;
}

}  // namespace cvo_slam::synthetic
