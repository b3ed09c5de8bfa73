// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parts of the Python module. Each function adds its classes and functions to the module; the
// order in which module.cc calls them is that of their dependencies.
#pragma once

#include <pybind11/pybind11.h>

namespace cvo_slam::python {

void bind_errors(pybind11::module_& module);
void bind_options(pybind11::module_& module);
void bind_camera(pybind11::module_& module);
void bind_frames(pybind11::module_& module);
void bind_trajectory(pybind11::module_& module);
void bind_tracking(pybind11::module_& module);
void bind_pose_graph(pybind11::module_& module);
void bind_slam(pybind11::module_& module);
void bind_map(pybind11::module_& module);

}  // namespace cvo_slam::python
