// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/slam/slam.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/vocabulary.h"
#include "cvo_slam/python/arrays_internal.h"
#include "cvo_slam/python/bindings_internal.h"
#include "cvo_slam/python/next_frame_internal.h"

namespace py = pybind11;

namespace cvo_slam::python {
namespace {

/// Slam, and the index of a frame that is given as arrays.
struct PySlam {
  Slam slam;
  NextFrame next;

  FrameRecord track(const RgbdFrame& frame) {
    return next.track(frame, [this](const RgbdFrame& f) { return slam.track(f); });
  }
};

TrajectoryView view_of_name(const std::string& name) {
  if (name == "final") return TrajectoryView::kFinal;
  if (name == "online") return TrajectoryView::kOnline;
  throw OptionError("view is '" + name + "'; use 'final' or 'online'");
}

void bind_vocabulary(py::module_& module) {
  // Immutable, so that Python may share what it holds.
  py::class_<Vocabulary, std::shared_ptr<Vocabulary>>(
      module, "Vocabulary", "A tree of ORB descriptors, by which places are recognised.")
      .def_static(
          "builtin", [] { return std::const_pointer_cast<Vocabulary>(builtin_vocabulary()); },
          "The vocabulary that Slam uses if it is given none.")
      .def_static(
          "read",
          [](const std::filesystem::path& file) {
            const py::gil_scoped_release release;
            return std::make_shared<Vocabulary>(read_vocabulary(file));
          },
          py::arg("file"), "Reads a vocabulary of cvo_slam, or one of ORB-SLAM2 as text.")
      .def_property_readonly("words", &Vocabulary::words, "Number of words.")
      .def_property_readonly("branching", &Vocabulary::branching)
      .def_property_readonly("levels", &Vocabulary::levels)
      .def("__repr__", [](const Vocabulary& self) {
        return fmt::format("<Vocabulary: {} words>", self.words());
      });
}

void bind_results(py::module_& module) {
  py::class_<Keyframe>(module, "Keyframe", "A keyframe of the map.")
      .def_readonly("number", &Keyframe::number, "Index of its frame.")
      .def_property_readonly(
          "stamp", [](const Keyframe& self) { return seconds_of(self.stamp); }, "[s]")
      .def_readonly("submap", &Keyframe::submap,
                    "Poses of different submaps have different worlds.")
      .def_property_readonly(
          "T_world_camera", [](const Keyframe& self) { return to_array(self.T_world_camera); },
          "Shape (4, 4) [m].")
      .def("__repr__", [](const Keyframe& self) {
        return fmt::format("<Keyframe {} at {} s>", self.number, self.stamp.to_string());
      });
  py::class_<LoopCandidate>(module, "LoopCandidate", "A pair of keyframes that was tried.")
      .def_readonly("from_number", &LoopCandidate::from, "Of the older keyframe.")
      .def_readonly("to_number", &LoopCandidate::to, "Of the newer one.")
      .def_property_readonly("kind",
                             [](const LoopCandidate& self) {
                               return self.kind == EdgeKind::kLoop ? "loop" : "proximity";
                             })
      .def_readonly("accepted", &LoopCandidate::accepted, "True if it is an edge of the graph.")
      .def_readonly("reason", &LoopCandidate::reason, "Why it is not an edge.")
      .def_readonly("inliers", &LoopCandidate::inliers, "Features that agree with one pose.")
      .def_readonly("overlap", &LoopCandidate::overlap)
      .def_readonly("cos_theta", &LoopCandidate::cos_theta)
      .def("__repr__", [](const LoopCandidate& self) {
        return fmt::format("<LoopCandidate {} - {}: {}>", self.from, self.to,
                           self.accepted ? "accepted" : self.reason);
      });
}

}  // namespace

void bind_slam(py::module_& module) {
  bind_vocabulary(module);
  bind_results(module);
  py::class_<PySlam>(module, "Slam",
                     "Tracks an RGB-D camera and builds a map of keyframes; loops are closed.\n\n"
                     "  slam = Slam(camera)\n"
                     "  for i in range(len(data)): slam.track(data.read(i))\n"
                     "  slam.finish()\n"
                     "  slam.trajectory().write('trajectory.txt')")
      .def(py::init([](const Camera& camera, const SlamOptions& options,
                       const std::shared_ptr<Vocabulary>& vocabulary) {
             const py::gil_scoped_release release;
             return PySlam{Slam(camera, options, vocabulary), {}};
           }),
           py::arg("camera"), py::arg("options") = SlamOptions(),
           py::arg("vocabulary") = std::shared_ptr<Vocabulary>())
      .def(py::init([](const Map& map, const SlamOptions& options, bool localize, bool resume,
                       const std::shared_ptr<Vocabulary>& vocabulary) {
             if (localize && resume) throw OptionError("either localize or resume can be True");
             const py::gil_scoped_release release;
             const MapUse use = localize ? MapUse::kLocalize
                                : resume ? MapUse::kResume
                                         : MapUse::kExtend;
             Slam slam(map, options, use, vocabulary);
             const NextFrame next(slam.next_index());
             return PySlam{std::move(slam), next};
           }),
           py::arg("map"), py::arg("options") = SlamOptions(), py::kw_only(),
           py::arg("localize") = false, py::arg("resume") = false,
           py::arg("vocabulary") = std::shared_ptr<Vocabulary>(),
           "Goes on from a map with memory. With localize, the map stays as it is and frames are "
           "located in it. With resume, tracking goes on bit for bit where map(session=True) was "
           "called, if options and vocabulary are the same.")
      .def("track", &PySlam::track, py::arg("frame"),
           "Tracks the next frame and returns its FrameRecord. Bad images do not raise: the record "
           "says that the frame is lost, and why.")
      .def(
          "track",
          [](PySlam& self, const py::array& rgb, const py::array& depth, double stamp,
             const std::optional<double>& depth_stamp) {
            return self.track(self.next.frame(rgb, depth, stamp, depth_stamp));
          },
          py::arg("rgb"), py::arg("depth"), py::arg("stamp"), py::arg("depth_stamp") = py::none(),
          "The same for the images of RgbdFrame; stamps in seconds.")
      .def(
          "track",
          [](PySlam& self, const py::array& rgb,
             const std::vector<std::pair<py::array, double>>& depths, double stamp) {
            if (depths.empty()) throw DataError("track() needs a depth image to choose from");
            const RgbdFrame frame = self.next.frame(rgb, depths[0].first, stamp, std::nullopt);
            std::vector<DepthImage> images;
            for (const auto& [depth, depth_stamp] : depths) {
              images.push_back({depth_image_from(depth), stamp_from(depth_stamp, "depth_stamp")});
            }
            return self.next.track(frame,
                                   [&](const RgbdFrame& f) { return self.slam.track(f, images); });
          },
          py::arg("rgb"), py::arg("depths"), py::arg("stamp"),
          "The same with the nearest of several depth images, pairs of an array and its stamp [s], "
          "say the one before and the one after: Camera.depth_offset is added to their stamps.")
      .def_property_readonly(
          "next_index", [](const PySlam& self) { return self.slam.next_index(); },
          "The least RgbdFrame.index that track() takes next.")
      .def(
          "finish", [](PySlam& self) { self.slam.finish(); },
          py::call_guard<py::gil_scoped_release>(),
          "Optimises the whole graph; tracking may go on after it.")
      .def(
          "statistics",
          [](const PySlam& self) {
            const GraphStatistics statistics = self.slam.statistics();
            py::dict result;
            result["window_solves"] = statistics.window_solves;
            result["window_seconds"] = statistics.window_seconds;
            result["full_solves"] = statistics.full_solves;
            result["full_seconds"] = statistics.full_seconds;
            result["keyframe_bytes"] = statistics.keyframe_bytes;
            result["redundant_keyframes"] = statistics.redundant_keyframes;
            result["dropped_keyframes"] = statistics.dropped_keyframes;
            return result;
          },
          "How often the newest part and the whole of the graph were optimised, the wall time of "
          "that [s], the memory of the keyframes [bytes], and how many were removed as redundant "
          "and to keep within culling.max_memory.")
      .def(
          "observe",
          [](PySlam& self, std::function<void(const FrameRecord&)> frame,
             std::function<void(const std::vector<Keyframe>&)> correction) {
            self.slam.observe({std::move(frame), std::move(correction)});
          },
          py::arg("frame") = py::none(), py::arg("correction") = py::none(),
          "From now on calls frame(record) in each track(), and before that correction(keyframes) "
          "when an optimisation has moved keyframes. They must not call this object; what they "
          "raise, track() and finish() raise after their work is done. Functions that hold this "
          "object "
          "keep it alive until observe() is called without them.")
      .def(
          "trajectory",
          [](const PySlam& self, const std::string& view) {
            return self.slam.trajectory(view_of_name(view));
          },
          py::arg("view") = "final",
          "The path of the camera: 'final', as the graph has it now, or 'online', as track() "
          "answered.")
      .def(
          "map",
          [](const PySlam& self, bool session) {
            const py::gil_scoped_release release;
            return self.slam.map(session ? MapContent::kSession : MapContent::kKeyframes);
          },
          py::kw_only(), py::arg("session") = false,
          "The map, to be written and gone on from; without points of its surface. With session, "
          "Slam(map, resume=True) goes on bit for bit between the same two frames.")
      .def(
          "pose_graph", [](const PySlam& self) { return self.slam.pose_graph(); },
          "A copy of the graph of the keyframes.")
      .def("keyframes", [](const PySlam& self) { return self.slam.keyframes(); })
      .def(
          "loop_candidates", [](const PySlam& self) { return self.slam.loop_candidates(); },
          "Every pair of keyframes that was tried.");
}

}  // namespace cvo_slam::python
