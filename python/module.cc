// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The Python module cvo_slam: docs/guide/python.md.
#include "cvo_slam/python/bindings_internal.h"

PYBIND11_MODULE(_cvo_slam, module) {
  using namespace cvo_slam::python;  // NOLINT(google-build-using-namespace)
  bind_errors(module);
  bind_options(module);
  bind_camera(module);
  bind_trajectory(module);
  bind_frames(module);
  bind_tracking(module);
  bind_pose_graph(module);
  bind_slam(module);
  bind_map(module);
  module.attr("__version__") = CVO_SLAM_VERSION;
}
