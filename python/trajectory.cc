// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/python/arrays_internal.h"
#include "cvo_slam/python/bindings_internal.h"

namespace py = pybind11;

namespace cvo_slam::python {
namespace {

Alignment alignment_of(const std::string& name) {
  if (name == "se3") return Alignment::kSe3;
  if (name == "sim3") return Alignment::kSim3;
  if (name == "none") return Alignment::kNone;
  throw OptionError("align is '" + name + "'; use 'se3', 'sim3' or 'none'");
}

DeltaUnit unit_of(const std::string& name) {
  for (const DeltaUnit unit : {DeltaUnit::kSeconds, DeltaUnit::kMetres, DeltaUnit::kFrames}) {
    if (name == to_string(unit)) return unit;
  }
  throw OptionError("unit is '" + name + "'; use 's', 'm' or 'frames'");
}

Doubles values_of(const std::vector<PoseError>& errors, double PoseError::*member) {
  Doubles array(static_cast<py::ssize_t>(errors.size()));
  for (std::size_t i = 0; i < errors.size(); ++i) array.mutable_data()[i] = errors[i].*member;
  return array;
}

Doubles stamps_of(const std::vector<PoseError>& errors) {
  Doubles array(static_cast<py::ssize_t>(errors.size()));
  for (std::size_t i = 0; i < errors.size(); ++i) {
    array.mutable_data()[i] = seconds_of(errors[i].stamp);
  }
  return array;
}

/// What both kinds of errors have.
template <typename Error, typename Class>
Class& bind_errors_of(Class& error) {
  error
      .def_property_readonly(
          "translation", [](const Error& self) { return self.statistics.translation; }, "[m]")
      .def_property_readonly(
          "rotation", [](const Error& self) { return self.statistics.rotation; }, "[rad]")
      .def_property_readonly(
          "stamps", [](const Error& self) { return stamps_of(self.errors); },
          "Of the errors, shape (N) [s].")
      .def_property_readonly(
          "translations",
          [](const Error& self) { return values_of(self.errors, &PoseError::translation); },
          "Shape (N) [m].")
      .def_property_readonly(
          "rotations",
          [](const Error& self) { return values_of(self.errors, &PoseError::rotation); },
          "Shape (N) [rad].");
  return error;
}

template <typename Error>
std::string describe_error(const char* name, const Error& error) {
  return fmt::format("<{}: {:.4g} m, {:.4g} rad RMSE of {}>", name,
                     error.statistics.translation.rmse, error.statistics.rotation.rmse,
                     error.errors.size());
}

Trajectory read_trajectory(const std::filesystem::path& file) {
  ForeignTrajectory read = read_foreign_tum(file);
  warn(read.notes);
  return {std::move(read.poses), {}};
}

std::vector<std::pair<double, std::string>> lost_frames(const Trajectory& trajectory) {
  std::vector<std::pair<double, std::string>> lost;
  for (const LostFrame& frame : trajectory.lost) {
    lost.emplace_back(seconds_of(frame.stamp), frame.reason);
  }
  return lost;
}

}  // namespace

void bind_trajectory(py::module_& module) {
  py::class_<Trajectory>(module, "Trajectory", "The path of a camera: T_world_camera over time.")
      .def(py::init([](const py::object& stamps, const py::object& poses) {
             return Trajectory{stamped_poses_from(stamps, poses), {}};
           }),
           py::arg("stamps"), py::arg("poses"),
           "stamps: ascending, shape (N) [s]; poses: rigid matrices T_world_camera of shape "
           "(N, 4, 4) [m].")
      .def("__len__", [](const Trajectory& self) { return self.poses.size(); })
      .def_property_readonly(
          "stamps", [](const Trajectory& self) { return python::stamps_of(self.poses); },
          "Shape (N) [s].")
      .def_property_readonly(
          "poses", [](const Trajectory& self) { return to_array(self.poses); },
          "T_world_camera, shape (N, 4, 4) [m].")
      .def_property_readonly(
          "positions",
          [](const Trajectory& self) {
            Doubles array({static_cast<py::ssize_t>(self.poses.size()), py::ssize_t{3}});
            double* values = array.mutable_data();
            for (const StampedPose& pose : self.poses) {
              for (int i = 0; i < 3; ++i) *values++ = pose.T_world_camera.translation()[i];
            }
            return array;
          },
          "Of the camera in the world, shape (N, 3) [m].")
      .def_property_readonly("lost", &lost_frames,
                             "Stamps [s] of the frames without a pose, with the reasons.")
      .def_property_readonly(
          "length", [](const Trajectory& self) { return path_length(self.poses); },
          "Of the path [m].")
      .def_static("read", &read_trajectory, py::arg("file"),
                  "Reads a file in TUM format; lines that are left out are a UserWarning.")
      .def(
          "write",
          [](const Trajectory& self, const std::filesystem::path& file) { write_tum(file, self); },
          py::arg("file"), "Writes a file in TUM format.")
      .def("__repr__", [](const Trajectory& self) {
        const double seconds =
            self.poses.empty() ? 0
                               : seconds_between(self.poses.front().stamp, self.poses.back().stamp);
        return fmt::format("<Trajectory: {} poses, {:.1f} s, {:.2f} m, {} frames lost>",
                           self.poses.size(), seconds, path_length(self.poses), self.lost.size());
      });

  py::class_<Statistics>(module, "Statistics", "Figures of a list of errors.")
      .def_readonly("count", &Statistics::count)
      .def_readonly("rmse", &Statistics::rmse)
      .def_readonly("mean", &Statistics::mean)
      .def_readonly("median", &Statistics::median)
      .def_readonly("std", &Statistics::std)
      .def_readonly("min", &Statistics::min)
      .def_readonly("max", &Statistics::max)
      .def("__repr__", [](const Statistics& self) {
        return fmt::format("<Statistics: rmse {:.4g}, median {:.4g}, max {:.4g} of {}>", self.rmse,
                           self.median, self.max, self.count);
      });

  py::class_<AbsoluteTrajectoryError> absolute(module, "AbsoluteTrajectoryError",
                                               "Distances of an estimate from the reference.");
  bind_errors_of<AbsoluteTrajectoryError>(absolute)
      .def_property_readonly(
          "T_reference_estimate",
          [](const AbsoluteTrajectoryError& self) {
            return to_array(self.alignment.T_reference_estimate);
          },
          "The alignment, shape (4, 4) [m].")
      .def_property_readonly(
          "scale", [](const AbsoluteTrajectoryError& self) { return self.alignment.scale; },
          "Of the alignment; 1 but for 'sim3'.")
      .def("__repr__", [](const AbsoluteTrajectoryError& self) {
        return describe_error("AbsoluteTrajectoryError", self);
      });
  py::class_<RelativePoseError> relative(module, "RelativePoseError", "The drift over a distance.");
  bind_errors_of<RelativePoseError>(relative).def("__repr__", [](const RelativePoseError& self) {
    return describe_error("RelativePoseError", self);
  });

  module.def(
      "ate",
      [](const Trajectory& reference, const Trajectory& estimate, const std::string& align,
         double max_difference, double time_offset, bool interpolate) {
        return absolute_trajectory_error(associate(reference.poses, estimate.poses,
                                                   {.max_difference = max_difference,
                                                    .time_offset = time_offset,
                                                    .interpolate = interpolate}),
                                         alignment_of(align));
      },
      py::arg("reference"), py::arg("estimate"), py::kw_only(), py::arg("align") = "se3",
      py::arg("max_difference") = AssociationOptions().max_difference, py::arg("time_offset") = 0.0,
      py::arg("interpolate") = false,
      "Returns the absolute trajectory error (Sturm et al., IROS 2012, Eq. 4).\n\n"
      "align: 'se3', 'sim3' or 'none'; max_difference of the stamps of a match [s]; time_offset is "
      "added to the estimate's stamps [s].");
  module.def(
      "rpe",
      [](const Trajectory& reference, const Trajectory& estimate, double delta,
         const std::string& unit, double max_difference, double time_offset, bool interpolate) {
        return relative_pose_error(associate(reference.poses, estimate.poses,
                                             {.max_difference = max_difference,
                                              .time_offset = time_offset,
                                              .interpolate = interpolate}),
                                   {.delta = delta, .unit = unit_of(unit)});
      },
      py::arg("reference"), py::arg("estimate"), py::kw_only(), py::arg("delta") = 1.0,
      py::arg("unit") = "s", py::arg("max_difference") = AssociationOptions().max_difference,
      py::arg("time_offset") = 0.0, py::arg("interpolate") = false,
      "Returns the relative pose error over a distance (Sturm et al., IROS 2012, Eq. 2).\n\n"
      "unit of delta: 's', 'm' or 'frames'; the others as in ate().");
}

}  // namespace cvo_slam::python
