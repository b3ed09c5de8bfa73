// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures the back-end beside the usual way to write a pose graph in Ceres: automatic derivatives,
// position and quaternion in separate blocks, Ceres' manifold and default options.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <benchmark/benchmark.h>
#include <ceres/autodiff_cost_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/io/g2o.h"

namespace cvo_slam {
namespace {

constexpr std::array kGraphs = {"sphere2500", "parking-garage", "smallGrid3D"};

/// The residual of core/pose_graph.h for Ceres' automatic derivatives.
struct AutomaticEdge {
  Eigen::Vector3d p_ab;
  Eigen::Quaterniond q_ab;
  Eigen::Matrix<double, 6, 6> square_root;

  template <typename T>
  bool operator()(const T* p_a, const T* q_a, const T* p_b, const T* q_b, T* residual) const {
    using Vector = Eigen::Matrix<T, 3, 1>;
    using Quaternion = Eigen::Quaternion<T>;
    const Quaternion world_a = Eigen::Map<const Quaternion>(q_a);
    const Quaternion a_b = world_a.conjugate() * Eigen::Map<const Quaternion>(q_b);
    const Vector between = Eigen::Map<const Vector>(p_b) - Eigen::Map<const Vector>(p_a);
    const Quaternion error = q_ab.template cast<T>() * a_b.conjugate();
    Eigen::Matrix<T, 6, 1> r;
    r.template head<3>() = world_a.conjugate() * between - p_ab.template cast<T>();
    r.template tail<3>() = T(2.0) * error.vec();
    Eigen::Map<Eigen::Matrix<T, 6, 1>> out(residual);
    out = square_root.template cast<T>() * r;
    return true;
  }
};

struct AutomaticPose {
  Eigen::Vector3d p;
  Eigen::Quaterniond q;
};

/// Optimises by the usual formulation. Returns the number of iterations.
int optimize_automatically(PoseGraph& graph) {
  std::vector<AutomaticPose> poses;
  for (const PoseGraphNode& node : graph.nodes()) {
    poses.push_back(
        {node.T_world_node.translation(), Eigen::Quaterniond(node.T_world_node.rotation())});
  }
  ceres::Problem problem;
  auto manifold = std::make_unique<ceres::EigenQuaternionManifold>();
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const PoseGraphEdge& edge = graph.edges()[i];
    auto functor = std::make_unique<AutomaticEdge>(
        AutomaticEdge{edge.T_from_to.translation(), Eigen::Quaterniond(edge.T_from_to.rotation()),
                      square_root_of_information(edge.information)});
    auto cost = std::make_unique<ceres::AutoDiffCostFunction<AutomaticEdge, 6, 3, 4, 3, 4>>(
        functor.release());
    AutomaticPose& a = poses[graph.ends()[i].first];
    AutomaticPose& b = poses[graph.ends()[i].second];
    problem.AddResidualBlock(cost.release(), nullptr, a.p.data(), a.q.coeffs().data(), b.p.data(),
                             b.q.coeffs().data());
  }
  ceres::Manifold* shared = manifold.release();  // the problem owns it from here on
  for (AutomaticPose& pose : poses) problem.SetManifold(pose.q.coeffs().data(), shared);
  problem.SetParameterBlockConstant(poses[0].p.data());
  problem.SetParameterBlockConstant(poses[0].q.coeffs().data());

  ceres::Solver::Options options;
  options.max_num_iterations = 200;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    graph.set_pose(i, SE3(poses[i].q.normalized().toRotationMatrix(), poses[i].p));
  }
  return static_cast<int>(summary.iterations.size()) - 1;
}

enum class Start { kFile, kChordal };

/// Returns the graph for a benchmark's arguments (index in kGraphs, Start), without nodes if the
/// file is not on this machine.
PoseGraph make_graph(benchmark::State& state) {
  const char* name = kGraphs[state.range(0)];
  const char* data = std::getenv("CVO_SLAM_DATA");
  const auto file = std::filesystem::path(data != nullptr ? data : "../shared/data") /
                    "pose_graphs" / (std::string(name) + ".g2o");
  if (!std::filesystem::exists(file)) {
    state.SkipWithError("no graphs; set CVO_SLAM_DATA");
    return {};
  }
  PoseGraph graph = read_g2o(file);
  const bool chordal = static_cast<Start>(state.range(1)) == Start::kChordal;
  if (chordal) {
    const auto poses = chordal_initialization(graph);
    for (std::size_t i = 0; poses && i < poses->size(); ++i) graph.set_pose(i, (*poses)[i]);
  }
  state.SetLabel(std::string(name) + (chordal ? ", chordal start" : ", the file's start"));
  return graph;
}

/// Times `solve`, which returns its number of iterations, on copies of the graph.
template <typename Solve>
void time_solve(benchmark::State& state, const Solve& solve) {
  const PoseGraph start = make_graph(state);
  int iterations = 0;
  double cost = 0;
  for ([[maybe_unused]] auto iteration : state) {
    state.PauseTiming();
    PoseGraph graph = start;
    state.ResumeTiming();
    iterations = solve(graph);
    state.PauseTiming();
    cost = graph_cost(graph);
    state.ResumeTiming();
  }
  state.counters["cost"] = cost;
  state.counters["iterations"] = iterations;
}

void automatic_derivatives(benchmark::State& state) { time_solve(state, optimize_automatically); }

/// From the start of the file, `optimize` may take the chordal start, whose time counts.
void ours(benchmark::State& state) {
  OptimizerOptions options;
  if (static_cast<Start>(state.range(1)) == Start::kChordal) {
    options.initialization = Initialization::kGiven;
  }
  time_solve(state, [&](PoseGraph& graph) { return optimize(graph, options).iterations; });
}

void ours_on_eigen(benchmark::State& state) {
  OptimizerOptions options;
  options.solver = LinearSolver::kEigen;
  time_solve(state, [&](PoseGraph& graph) { return optimize(graph, options).iterations; });
}

void chordal(benchmark::State& state) {
  time_solve(state, [](PoseGraph& graph) { return chordal_initialization(graph) ? 1 : 0; });
}

void all_graphs(benchmark::internal::Benchmark* benchmark) {
  for (const Start start : {Start::kFile, Start::kChordal}) {
    for (int graph = 0; graph < 3; ++graph) benchmark->Args({graph, static_cast<int>(start)});
  }
  benchmark->Unit(benchmark::kMillisecond);
}

BENCHMARK(automatic_derivatives)->Apply(all_graphs);
BENCHMARK(ours)->Apply(all_graphs);
BENCHMARK(ours_on_eigen)->Args({0, 0})->Unit(benchmark::kMillisecond);
BENCHMARK(chordal)->Args({0, 0})->Args({1, 0})->Args({2, 0})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cvo_slam
