// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/io/followed_dataset.h"
#include "cvo_slam/python/arrays_internal.h"
#include "cvo_slam/python/bindings_internal.h"
#include "cvo_slam/python/next_frame_internal.h"

namespace py = pybind11;

namespace cvo_slam::python {
namespace {

/// The frame outlives the call, and the caller may write to the arrays: their pixels are copied.
RgbdFrame make_frame(const py::array& rgb, const py::array& depth, double stamp,
                     const std::optional<double>& depth_stamp, std::size_t index) {
  RgbdFrame frame = frame_of_arrays(index, rgb, depth, stamp, depth_stamp);
  frame.color = frame.color.clone();
  frame.depth = frame.depth.clone();
  return frame;
}

std::unique_ptr<Dataset> open(const std::filesystem::path& folder,
                              const std::optional<Camera>& camera,
                              const std::optional<std::filesystem::path>& associations,
                              double max_stamp_difference,
                              const std::optional<double>& depth_offset,
                              const std::optional<double>& frame_rate) {
  const py::gil_scoped_release release;
  return open_dataset(folder, {.camera = camera,
                               .max_stamp_difference = max_stamp_difference,
                               .associations = associations,
                               .depth_offset = depth_offset,
                               .frame_rate = frame_rate});
}

/// True if the user has pressed Ctrl-C; Python's exception is set then.
bool is_interrupted() {
  const py::gil_scoped_acquire acquire;
  return PyErr_CheckSignals() != 0;
}

/// Calls a function that waits in a followed folder, with the interpreter free for other threads.
template <typename Function>
auto waiting(const Function& function) {
  try {
    const py::gil_scoped_release release;
    return function();
  } catch (const InputError&) {
    if (PyErr_Occurred() == nullptr) throw;
    throw py::error_already_set();
  }
}

std::unique_ptr<FollowedDataset> follow(const std::filesystem::path& folder, double end_after,
                                        const std::optional<Camera>& camera,
                                        double max_stamp_difference,
                                        const std::optional<double>& depth_offset,
                                        const std::optional<double>& frame_rate) {
  return waiting([&] {
    return std::make_unique<FollowedDataset>(
        folder,
        DatasetOptions{.camera = camera,
                       .max_stamp_difference = max_stamp_difference,
                       .depth_offset = depth_offset,
                       .frame_rate = frame_rate},
        FollowOptions{.end_after = end_after, .stop = is_interrupted});
  });
}

RgbdFrame next_of(FollowedDataset& frames) {
  auto frame = waiting([&] { return frames.next(); });
  if (frame) return *std::move(frame);
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  throw py::stop_iteration();
}

/// The index of a frame, from the end if it is negative.
std::size_t frame_index(const Dataset& data, py::ssize_t index) {
  const auto size = static_cast<py::ssize_t>(data.size());
  if (index < 0) index += size;
  if (index < 0 || index >= size) {
    throw py::index_error(fmt::format("the sequence has {} frames", size));
  }
  return static_cast<std::size_t>(index);
}

}  // namespace

void bind_frames(py::module_& module) {
  py::class_<RgbdFrame>(module, "RgbdFrame", "A colour image with its depth image.")
      .def(py::init(&make_frame), py::arg("rgb"), py::arg("depth"), py::arg("stamp"),
           py::arg("depth_stamp") = py::none(), py::arg("index") = 0,
           "rgb: uint8 (H, W, 3), red first, or (H, W); depth: uint16 (H, W), registered to the "
           "colour image, Camera.depth_scale units a metre, 0 = none; stamps in seconds. The "
           "arrays are copied.")
      .def_property_readonly(
          "rgb", [](const RgbdFrame& self) { return view_of(self.color); },
          "uint8 (H, W, 3), red first, or (H, W); a view for reading. None if it could not be "
          "read.")
      .def_property_readonly(
          "depth", [](const RgbdFrame& self) { return view_of(self.depth); },
          "uint16 (H, W), Camera.depth_scale units a metre; a view for reading.")
      .def_property_readonly(
          "stamp", [](const RgbdFrame& self) { return seconds_of(self.stamp); },
          "Of the colour image [s].")
      .def_property_readonly(
          "depth_stamp", [](const RgbdFrame& self) { return seconds_of(self.depth_stamp); },
          "Of the depth image [s].")
      .def_readonly("index", &RgbdFrame::index, "Position in its sequence.")
      .def_readonly("problem", &RgbdFrame::problem,
                    "Why the images could not be read; empty if they could.")
      .def("__repr__", [](const RgbdFrame& self) {
        return fmt::format("<RgbdFrame {} at {} s, {} x {}{}{}>", self.index,
                           self.stamp.to_string(), self.color.cols, self.color.rows,
                           self.problem.empty() ? "" : ": ", self.problem);
      });

  py::class_<Dataset>(module, "Dataset",
                      "A recorded sequence: len(), data[i] and iteration give its frames.")
      .def("__len__", &Dataset::size)
      .def(
          "read",
          [](const Dataset& self, py::ssize_t index) {
            const std::size_t frame = frame_index(self, index);
            const py::gil_scoped_release release;
            return self.read(frame);
          },
          py::arg("index"),
          "Reads a frame. If an image is missing or broken, its `problem` says why.")
      .def("__getitem__",
           [](const Dataset& self, py::ssize_t index) {
             const std::size_t frame = frame_index(self, index);
             const py::gil_scoped_release release;
             return self.read(frame);
           })
      .def("__iter__",
           [](const py::object& self) {
             return py::reinterpret_steal<py::object>(PySeqIter_New(self.ptr()));
           })
      .def_property_readonly("name", &Dataset::name, "The name of its folder.")
      .def_property_readonly("kind", &Dataset::kind, "Its format, for people.")
      .def_property_readonly("camera", &Dataset::camera)
      .def_property_readonly("camera_origin", &Dataset::camera_origin, "Why this camera is used.")
      .def_property_readonly(
          "stamps",
          [](const Dataset& self) {
            Doubles stamps(static_cast<py::ssize_t>(self.size()));
            for (std::size_t i = 0; i < self.size(); ++i) {
              stamps.mutable_data()[i] = seconds_of(self.stamp(i));
            }
            return stamps;
          },
          "Of the colour images, shape (N) [s].")
      .def_property_readonly(
          "reference",
          [](const Dataset& self) {
            return Trajectory{self.reference(), {}};
          },
          "The ground truth; without poses if there is none.")
      .def_property_readonly("notes", &Dataset::notes, "What a user should know, a line each.")
      .def("__repr__", [](const Dataset& self) {
        return fmt::format("<Dataset '{}': {} frames, {}, camera '{}'>", self.name(), self.size(),
                           self.kind(), self.camera().name);
      });

  py::class_<FollowedDataset, Dataset>(
      module, "FollowedDataset",
      "A recording that is still being written: iteration waits for its frames and ends when "
      "nothing has changed for a while. len() and [i] are those returned so far.")
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", &next_of);

  module.def("open_dataset", &open, py::arg("folder"), py::kw_only(),
             py::arg("camera") = py::none(), py::arg("associations") = py::none(),
             py::arg("max_stamp_difference") = DatasetOptions().max_stamp_difference,
             py::arg("depth_offset") = py::none(), py::arg("frame_rate") = py::none(),
             "Opens a recorded sequence in one of the formats of docs/guide/your-camera.md.\n\n"
             "camera: a Camera in place of the recording's own; associations: a file that pairs "
             "the images; max_stamp_difference [s] of a pair; depth_offset: what is added to depth "
             "stamps [s]; frame_rate: of images that are numbered and have no stamps [Hz].");
  module.def(
      "follow_dataset", &follow, py::arg("folder"), py::kw_only(),
      py::arg("end_after") = FollowOptions().end_after, py::arg("camera") = py::none(),
      py::arg("max_stamp_difference") = DatasetOptions().max_stamp_difference,
      py::arg("depth_offset") = py::none(), py::arg("frame_rate") = py::none(),
      "Follows a folder that a recorder writes to, and waits until there is something in "
      "it.\n\nend_after: the recording has ended when nothing has changed for so long [s]; "
      "the others as in open_dataset(), but that no frame rate is guessed (30 Hz). Ctrl-C ends "
      "the waiting.");
}

}  // namespace cvo_slam::python
