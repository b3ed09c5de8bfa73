// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/map.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/python/arrays_internal.h"
#include "cvo_slam/python/bindings_internal.h"
#include "cvo_slam/render/picture.h"

namespace py = pybind11;

namespace cvo_slam::python {
namespace {

Doubles points_of(const Map& map) {
  Doubles array({static_cast<py::ssize_t>(map.points.size()), py::ssize_t{3}});
  double* values = array.mutable_data();
  for (const MapPoint& point : map.points) {
    const Vector3 position = map.points_origin + point.position.cast<double>();
    values = std::copy_n(position.data(), 3, values);
  }
  return array;
}

py::array_t<float> normals_of(const Map& map) {
  py::array_t<float> array({static_cast<py::ssize_t>(map.points.size()), py::ssize_t{3}});
  float* values = array.mutable_data();
  for (const MapPoint& point : map.points) values = std::copy_n(point.normal.data(), 3, values);
  return array;
}

py::array_t<std::uint8_t> colors_of(const Map& map) {
  py::array_t<std::uint8_t> array({static_cast<py::ssize_t>(map.points.size()), py::ssize_t{3}});
  std::uint8_t* values = array.mutable_data();
  for (const MapPoint& point : map.points) values = std::copy_n(point.color.data(), 3, values);
  return array;
}

render::ViewKind view_kind(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [text, kind] : render::view_names()) {
    if (text == name) return kind;
    names.push_back(text);
  }
  throw OptionError("no view is called '" + name + "'; " + suggestion(name, names));
}

render::RendererKind renderer_kind(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [text, kind] : render::renderer_names()) {
    if (text == name) return kind;
    names.push_back(text);
  }
  throw OptionError("no renderer is called '" + name + "'; " + suggestion(name, names));
}

py::object draw(const render::MapScene& scene, const std::string& view, int width, int height,
                const std::string& renderer) {
  const render::ViewOptions options = {.kind = view_kind(view), .width = width, .height = height};
  const render::RendererKind kind = renderer_kind(renderer);
  render::Picture picture;
  {
    const py::gil_scoped_release release;
    picture = render::draw_picture(scene, options, *render::make_renderer(kind));
  }
  return view_of(picture.image);
}

}  // namespace

void bind_map(py::module_& module) {
  py::class_<Map>(module, "Map", "Keyframes, their graph and the surface they saw.")
      .def_static(
          "read",
          [](const std::filesystem::path& folder) {
            const py::gil_scoped_release release;
            return read_map(folder);
          },
          py::arg("folder"), "Reads a map that was written, or the one in the folder of a run.")
      .def(
          "write",
          [](const Map& self, const std::filesystem::path& folder) { write_map(folder, self); },
          py::arg("folder"), "Writes a folder; that of a map with memory is replaced as a whole.")
      .def_property_readonly("keyframes",
                             [](const Map& self) {
                               return Trajectory{self.keyframes, {}};
                             })
      .def_readonly("graph", &Map::graph)
      .def_property_readonly(
          "has_memory", [](const Map& self) { return self.memory.has_value(); },
          "True if Slam can go on from it.")
      .def_property_readonly("points", &points_of, "Shape (N, 3) [m].")
      .def_property_readonly("normals", &normals_of, "Shape (N, 3); zero where there is none.")
      .def_property_readonly("colors", &colors_of, "uint8 of shape (N, 3), red first.")
      .def("__repr__", [](const Map& self) {
        return fmt::format("<Map: {} keyframes, {} points>", self.keyframes.size(),
                           self.points.size());
      });

  module.def(
      "render",
      [](const Map& map, const std::string& view, int width, int height,
         const std::string& renderer) {
        return draw(render::make_scene(map), view, width, height, renderer);
      },
      py::arg("map"), py::kw_only(), py::arg("view") = "iso", py::arg("width") = 1280,
      py::arg("height") = 720, py::arg("renderer") = "auto",
      "Draws a map or trajectory off-screen; returns uint8 of shape (height, width, 3), red first."
      "\n\nview: 'iso', 'top', 'front', 'side', 'turntable' or 'follow'; renderer: 'auto', "
      "'osmesa', 'egl' or 'splat'.");
  module.def(
      "render",
      [](const Trajectory& trajectory, const std::string& view, int width, int height,
         const std::string& renderer) {
        Map map;
        render::MapScene scene = render::make_scene(map);
        render::add_path_by_time(scene, "trajectory", trajectory.poses);
        return draw(scene, view, width, height, renderer);
      },
      py::arg("trajectory"), py::kw_only(), py::arg("view") = "iso", py::arg("width") = 1280,
      py::arg("height") = 720, py::arg("renderer") = "auto");
}

}  // namespace cvo_slam::python
