// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/frontend/tracker.h"

namespace cvo_slam {

/// Returns options for images of 320x240 pixels. They do not follow the defaults, which are tuned
/// on real sequences.
inline TrackerOptions tracker_test_options() {
  TrackerOptions o;
  o.reference = Reference::kKeyframe;
  o.prediction = Prediction::kConstantVelocity;
  o.points = 500;
  o.keyframe_points = 2000;
  o.compensate_depth_delay = true;
  o.threads = 1;
  o.selection.method = SelectionMethod::kGradient;
  o.selection.min_gradient = 4;
  o.selection.min_depth = 0.3;
  o.selection.max_depth = 6;
  o.selection.max_depth_step = 0.05;
  o.registration.solver = Solver::kNewton;
  o.registration.kernel.color_kernel = ColorKernel::kSquaredExponential;
  o.registration.kernel.color_scale = 60;
  o.registration.kernel.gradient_scale = 60;
  o.registration.length_scales = {0.1, 0.05, 0.025};
  o.registration.judged_length_scale = 0.025;
  o.registration.max_iterations = {10};
  o.registration.tolerance = 1e-4;
  o.keyframe.min_overlap = 0.7;
  o.keyframe.max_translation = 0.2;
  o.keyframe.max_rotation = 0.25;
  o.lost.min_points = 100;
  o.lost.min_overlap = 0.3;
  o.lost.min_cos_theta = 0.1;
  o.lost.max_speed = 3;
  o.lost.max_angular_speed = 6;
  o.lost.restart_time = 0.3;
  return o;
}

}  // namespace cvo_slam
