// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/camera.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/depth_registration.h"
#include "cvo_slam/python/arrays_internal.h"
#include "cvo_slam/python/bindings_internal.h"

namespace py = pybind11;

namespace cvo_slam::python {
namespace {

/// A property of the colour camera.
template <typename T>
void pinhole_property(py::class_<Camera>& camera, const char* name, T PinholeCamera::*member,
                      const char* doc) {
  camera.def_property(
      name, [member](const Camera& self) { return self.color.*member; },
      [member](Camera& self, const T& value) { self.color.*member = value; }, doc);
}

Camera make_camera(int width, int height, double fx, double fy, double cx, double cy,
                   const std::array<double, 5>& distortion, double depth_scale, double readout_time,
                   const std::optional<double>& depth_offset, const std::string& name) {
  Camera camera;
  camera.name = name;
  camera.color = {width, height, fx, fy, cx, cy, distortion};
  camera.depth_scale = depth_scale;
  camera.readout_time = readout_time;
  camera.depth_offset = depth_offset;
  camera.check();
  return camera;
}

}  // namespace

void bind_camera(py::module_& module) {
  py::class_<Camera> camera(
      module, "Camera",
      "An RGB-D camera: a pinhole with Brown's distortion, and the scale of its depth images.");
  camera.def(py::init(&make_camera), py::arg("width"), py::arg("height"), py::arg("fx"),
             py::arg("fy"), py::arg("cx"), py::arg("cy"), py::kw_only(),
             py::arg("distortion") = std::array<double, 5>{}, py::arg("depth_scale"),
             py::arg("readout_time") = 0.0, py::arg("depth_offset") = py::none(),
             py::arg("name") = "camera",
             "Sizes in pixels; distortion k1, k2, p1, p2, k3 as in OpenCV; depth_scale units of "
             "the uint16 depth image a metre (1000 for millimetres); readout_time of a rolling "
             "shutter [s]; depth_offset, what is added to depth stamps [s].");
  pinhole_property(camera, "width", &PinholeCamera::width, "[px]");
  pinhole_property(camera, "height", &PinholeCamera::height, "[px]");
  pinhole_property(camera, "fx", &PinholeCamera::fx, "[px]");
  pinhole_property(camera, "fy", &PinholeCamera::fy, "[px]");
  pinhole_property(camera, "cx", &PinholeCamera::cx, "[px]");
  pinhole_property(camera, "cy", &PinholeCamera::cy, "[px]");
  pinhole_property(camera, "distortion", &PinholeCamera::distortion,
                   "k1, k2, p1, p2, k3 as in OpenCV");
  camera.def_readwrite("name", &Camera::name, "For messages.")
      .def_readwrite("depth_scale", &Camera::depth_scale, "Units of the depth image a metre.")
      .def_readwrite("readout_time", &Camera::readout_time,
                     "From the first row to the last of a rolling shutter [s].")
      .def_readwrite("depth_offset", &Camera::depth_offset,
                     "What is added to the stamps of depth images [s]; None if it is not known.")
      .def_property_readonly(
          "has_depth_camera", [](const Camera& self) { return self.depth.has_value(); },
          "True if depth images come from a camera of their own and register_depth() is needed.")
      .def_static(
          "read", [](const std::filesystem::path& file) { return find_camera(file.string()); },
          py::arg("file"),
          "Reads a camera file (YAML, also of ORB-SLAM2 and its kin), or returns the "
          "built-in camera of that name.")
      .def(
          "write",
          [](const Camera& self, const std::filesystem::path& file) { write_camera(file, self); },
          py::arg("file"), "Writes a camera file.")
      .def_static("builtin_names", &builtin_camera_names, "The names of the built-in cameras.")
      .def("__repr__", [](const Camera& self) {
        const PinholeCamera& pinhole = self.color;
        return fmt::format(
            "<Camera '{}': {} x {}, fx {:g}, fy {:g}, cx {:g}, cy {:g}, "
            "depth_scale {:g}>",
            self.name, pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx,
            pinhole.cy, self.depth_scale);
      });

  module.def(
      "register_depth",
      [](const py::array& depth, const Camera& self) {
        return view_of(DepthRegistration(self).register_depth(depth_image_from(depth)));
      },
      py::arg("depth"), py::arg("camera"),
      "Returns a depth image of the camera's own depth camera as the colour camera sees it.");
}

}  // namespace cvo_slam::python
