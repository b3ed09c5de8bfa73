// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/pose_graph.h"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/io/g2o.h"
#include "cvo_slam/python/arrays_internal.h"
#include "cvo_slam/python/bindings_internal.h"

namespace py = pybind11;

namespace cvo_slam::python {
namespace {

constexpr std::array<std::pair<EdgeKind, const char*>, 3> kKinds = {
    {{EdgeKind::kOdometry, "odometry"},
     {EdgeKind::kProximity, "proximity"},
     {EdgeKind::kLoop, "loop"}}};

std::string name_of(EdgeKind kind) {
  for (const auto& [value, name] : kKinds) {
    if (value == kind) return name;
  }
  return {};
}

EdgeKind kind_of(const std::string& name) {
  for (const auto& [value, text] : kKinds) {
    if (name == text) return value;
  }
  throw OptionError("kind is '" + name + "'; use 'odometry', 'proximity' or 'loop'");
}

Doubles poses_of(const PoseGraph& graph) {
  std::vector<StampedPose> poses;
  for (const PoseGraphNode& node : graph.nodes()) poses.push_back({{}, node.T_world_node});
  return to_array(poses);
}

}  // namespace

void bind_pose_graph(py::module_& module) {
  py::class_<PoseGraphEdge>(module, "PoseGraphEdge", "A measured pose between two nodes.")
      .def_readonly("from_id", &PoseGraphEdge::from)
      .def_readonly("to_id", &PoseGraphEdge::to)
      .def_property_readonly(
          "T_from_to", [](const PoseGraphEdge& self) { return to_array(self.T_from_to); },
          "Shape (4, 4) [m].")
      .def_property_readonly(
          "information", [](const PoseGraphEdge& self) { return to_array(self.information); },
          "Inverse covariance of the residual, [translation; rotation], shape (6, 6).")
      .def_property_readonly(
          "kind", [](const PoseGraphEdge& self) { return name_of(self.kind); },
          "'odometry', 'proximity' or 'loop'.")
      .def_readonly("robust", &PoseGraphEdge::robust,
                    "True if it may be wrong: the robust loss applies to it.")
      .def("__repr__", [](const PoseGraphEdge& self) {
        return fmt::format("<PoseGraphEdge {} -> {}, {}>", self.from, self.to, name_of(self.kind));
      });

  py::class_<PoseGraph>(module, "PoseGraph", "Poses and measurements between them.")
      .def(py::init<>())
      .def(
          "add_node",
          [](PoseGraph& self, NodeId id, const py::object& pose, bool fixed) {
            self.add_node({id, pose_from(pose, "T_world_node"), fixed});
          },
          py::arg("id"), py::arg("T_world_node"), py::arg("fixed") = false,
          "fixed: optimisation must not move it.")
      .def(
          "add_edge",
          [](PoseGraph& self, NodeId from, NodeId to, const py::object& T_from_to,
             const py::object& information, const std::string& kind, bool robust) {
            self.add_edge({from, to, pose_from(T_from_to, "T_from_to"),
                           information.is_none() ? Matrix6(Matrix6::Identity())
                                                 : matrix6_from(information, "information"),
                           kind_of(kind), robust});
          },
          py::arg("from_id"), py::arg("to_id"), py::arg("T_from_to"),
          py::arg("information") = py::none(), py::arg("kind") = "odometry",
          py::arg("robust") = false,
          "information: symmetric, [translation; rotation], shape (6, 6); the identity if None.")
      .def_property_readonly(
          "ids",
          [](const PoseGraph& self) {
            std::vector<NodeId> ids;
            for (const PoseGraphNode& node : self.nodes()) ids.push_back(node.id);
            return ids;
          },
          "Of the nodes, in the order in which they were added.")
      .def_property_readonly("poses", &poses_of,
                             "T_world_node in the order of ids, shape (N, 4, 4) [m].")
      .def(
          "pose",
          [](const PoseGraph& self, NodeId id) {
            return to_array(self.nodes()[self.index_of(id)].T_world_node);
          },
          py::arg("id"), "Shape (4, 4) [m].")
      .def_property_readonly("edges", &PoseGraph::edges, "A list of copies.")
      .def_property_readonly("cost", &graph_cost, "Half the sum of the squared errors.")
      .def("__len__", [](const PoseGraph& self) { return self.nodes().size(); })
      .def_static(
          "read",
          [](const std::filesystem::path& file) {
            std::vector<std::string> notes;
            PoseGraph graph = read_g2o(file, notes);
            warn(notes);
            return graph;
          },
          py::arg("file"), "Reads a g2o file; entries that are skipped are a UserWarning.")
      .def(
          "write",
          [](const PoseGraph& self, const std::filesystem::path& file) { write_g2o(file, self); },
          py::arg("file"), "Writes a g2o file.")
      .def("__repr__", [](const PoseGraph& self) {
        return fmt::format("<PoseGraph: {} nodes, {} edges>", self.nodes().size(),
                           self.edges().size());
      });

  py::class_<Summary>(module, "Summary", "The result of an optimisation.")
      .def_readonly("initial_cost", &Summary::initial_cost)
      .def_readonly("final_cost", &Summary::final_cost, "Half the sum of the squared errors.")
      .def_readonly("iterations", &Summary::iterations)
      .def_readonly("converged", &Summary::converged)
      .def_readonly("reason", &Summary::reason, "Why the search ended.")
      .def_readonly("weights", &Summary::weights, "Of each edge, 0 to 1.")
      .def_readonly("notes", &Summary::notes, "What needs a look, a line each.")
      .def("__repr__", [](const Summary& self) {
        return fmt::format("<Summary: cost {:.6g} -> {:.6g}, {} iterations, {}>", self.initial_cost,
                           self.final_cost, self.iterations, self.reason);
      });
  module.def(
      "optimize",
      [](PoseGraph& graph, const OptimizerOptions& options) {
        const py::gil_scoped_release release;
        return optimize(graph, options);
      },
      py::arg("graph"), py::arg("options") = OptimizerOptions(),
      "Moves the nodes of the graph to the least-squares optimum.");
}

}  // namespace cvo_slam::python
