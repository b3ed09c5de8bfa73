// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/python/arrays_internal.h"
#include "cvo_slam/python/bindings_internal.h"
#include "cvo_slam/python/next_frame_internal.h"

namespace py = pybind11;

namespace cvo_slam::python {
namespace {

/// A tracker, and the index of a frame that is given as arrays.
struct PyTracker {
  Tracker tracker;
  NextFrame next;

  FrameRecord track(const RgbdFrame& frame) {
    return next.track(frame, [this](const RgbdFrame& f) { return tracker.track(f).record; });
  }
};

PointCloud make_cloud(const py::object& positions, const py::object& features) {
  const Doubles points = doubles_from(positions, {-1, 3}, "positions");
  const auto columns = static_cast<py::ssize_t>(PointCloud::kFeatures);
  const Doubles labels = doubles_from(features, {points.shape(0), columns}, "features");
  PointCloud cloud;
  cloud.resize(static_cast<std::size_t>(points.shape(0)));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    cloud.x[i] = static_cast<float>(points.at(row, 0));
    cloud.y[i] = static_cast<float>(points.at(row, 1));
    cloud.z[i] = static_cast<float>(points.at(row, 2));
    for (py::ssize_t k = 0; k < columns; ++k) {
      cloud.features[static_cast<std::size_t>(k)][i] = static_cast<float>(labels.at(row, k));
    }
  }
  return cloud;
}

Doubles features_of(const PointCloud& cloud) {
  constexpr std::size_t kColumns = PointCloud::kFeatures;
  Doubles array({static_cast<py::ssize_t>(cloud.size()), static_cast<py::ssize_t>(kColumns)});
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (std::size_t k = 0; k < kColumns; ++k) {
      array.mutable_data()[i * kColumns + k] = cloud.features[k][i];
    }
  }
  return array;
}

Doubles positions_of(const PointCloud& cloud) {
  Doubles array({static_cast<py::ssize_t>(cloud.size()), py::ssize_t{3}});
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vector3 position = cloud.position(i);
    std::copy_n(position.data(), 3, array.mutable_data() + 3 * i);
  }
  return array;
}

const char* status_of(const RegistrationResult& result) {
  switch (result.status) {
    case RegistrationStatus::kConverged:
      return "converged";
    case RegistrationStatus::kIterationLimit:
      return "iteration limit";
    case RegistrationStatus::kFailed:
      break;
  }
  return "failed";
}

void bind_record(py::module_& module) {
  py::class_<FrameRecord>(module, "FrameRecord", "What tracking says of one frame.")
      .def_readonly("index", &FrameRecord::index, "Of the frame.")
      .def_property_readonly(
          "stamp", [](const FrameRecord& self) { return seconds_of(self.stamp); }, "[s]")
      .def_property_readonly(
          "tracked",
          [](const FrameRecord& self) { return self.status == TrackingStatus::kTracked; },
          "False if the frame is lost.")
      .def_readonly("reason", &FrameRecord::reason, "Why the frame is lost; empty if it is not.")
      .def_property_readonly(
          "T_world_camera",
          [](const FrameRecord& self) -> py::object {
            if (self.status == TrackingStatus::kLost) return py::none();
            return to_array(self.T_world_camera);
          },
          "The pose, shape (4, 4) [m]; None if the frame is lost.")
      .def_readonly("submap", &FrameRecord::submap,
                    "Poses of different submaps have different worlds.")
      .def_readonly("localized", &FrameRecord::localized,
                    "True if the pose is in the world of the map that Slam was made from.")
      .def_readonly("keyframe", &FrameRecord::keyframe,
                    "Index of the frame that this one was registered to.")
      .def_readonly("keyframe_reason", &FrameRecord::keyframe_reason,
                    "Why the frame became a keyframe; empty if it did not.")
      .def_readonly("points", &FrameRecord::points, "Number of its points.")
      .def_readonly("doubt", &FrameRecord::doubt,
                    "Probability that the pose is wrong by more than 5 cm or 3 degrees.")
      .def_readonly("features_asked", &FrameRecord::features_asked,
                    "True if a start was looked for by features.")
      .def_readonly("registration", &FrameRecord::registration, "To the keyframe.")
      .def("__repr__", [](const FrameRecord& self) {
        const bool is_tracked = self.status == TrackingStatus::kTracked;
        return fmt::format("<FrameRecord {}: {}{}>", self.index, is_tracked ? "tracked" : "lost, ",
                           self.reason);
      });
}

}  // namespace

void bind_tracking(py::module_& module) {
  py::class_<RegistrationResult>(module, "RegistrationResult", "The result of a registration.")
      .def_property_readonly(
          "T_fixed_moving",
          [](const RegistrationResult& self) { return to_array(self.T_fixed_moving); },
          "Shape (4, 4) [m].")
      .def_property_readonly("status", &status_of, "'converged', 'iteration limit' or 'failed'.")
      .def_readonly("reason", &RegistrationResult::reason, "Why it ended as it did.")
      .def_readonly("iterations", &RegistrationResult::iterations)
      .def_readonly("overlap", &RegistrationResult::overlap,
                    "Share of the moving points that have a fixed one beside them, 0 to 1.")
      .def_readonly("cos_theta", &RegistrationResult::cos_theta,
                    "Normalised inner product of the two clouds, 0 to 1.")
      .def_property_readonly(
          "covariance", [](const RegistrationResult& self) { return to_array(self.covariance); },
          "Of a right perturbation, [translation; rotation], shape (6, 6).")
      .def("__repr__", [](const RegistrationResult& self) {
        return fmt::format("<RegistrationResult: {}, overlap {:.2f}, cos_theta {:.2f}>",
                           status_of(self), self.overlap, self.cos_theta);
      });
  bind_record(module);

  py::class_<PointCloud>(module, "PointCloud", "A coloured point cloud, as CVO registers it.")
      .def(py::init(&make_cloud), py::arg("positions"), py::arg("features"),
           "positions: shape (N, 3) [m]; features: blue, green, red, dI/dx, dI/dy of shape (N, 5), "
           "on the scale of 8-bit values.")
      .def("__len__", &PointCloud::size)
      .def_property_readonly("positions", &positions_of, "Shape (N, 3) [m].")
      .def_property_readonly("features", &features_of, "Shape (N, 5).")
      .def("__repr__", [](const PointCloud& self) {
        return fmt::format("<PointCloud: {} points>", self.size());
      });
  module.def(
      "select_points",
      [](const RgbdFrame& frame, const Camera& camera, int count) {
        const std::string problem = check_images(frame, camera);
        if (!problem.empty()) throw py::value_error("frame: " + problem);
        const py::gil_scoped_release release;
        return select_points(frame, camera, count);
      },
      py::arg("frame"), py::arg("camera"), py::arg("count") = 1500,
      "Returns the points of a frame where its gradients are strongest, evenly spread.");
  module.def(
      "align",
      [](const PointCloud& fixed, const PointCloud& moving, const py::object& T_init,
         const RegistrationOptions& options) {
        const SE3 start = T_init.is_none() ? SE3() : pose_from(T_init, "T_fixed_moving_init");
        const py::gil_scoped_release release;
        return align(fixed, moving, start, options);
      },
      py::arg("fixed"), py::arg("moving"), py::arg("T_fixed_moving_init") = py::none(),
      py::arg("options") = RegistrationOptions(),
      "Registers two clouds by CVO (Ghaffari et al., RSS 2019). Clouds without overlap give "
      "status 'failed'.");

  py::class_<PyTracker>(module, "Tracker",
                        "Tracks a camera against keyframes, without a map. See Slam.")
      .def(py::init([](const Camera& camera, const TrackerOptions& options) {
             return PyTracker{Tracker(camera, options), {}};
           }),
           py::arg("camera"), py::arg("options") = TrackerOptions())
      .def("track", &PyTracker::track, py::arg("frame"),
           "Tracks the next frame. Bad images do not raise: the record says that it is lost.")
      .def(
          "track",
          [](PyTracker& self, const py::array& rgb, const py::array& depth, double stamp,
             const std::optional<double>& depth_stamp) {
            return self.track(self.next.frame(rgb, depth, stamp, depth_stamp));
          },
          py::arg("rgb"), py::arg("depth"), py::arg("stamp"), py::arg("depth_stamp") = py::none(),
          "The same for the images of RgbdFrame; stamps in seconds.");
}

}  // namespace cvo_slam::python
