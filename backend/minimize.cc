// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include "cvo_slam/backend/between_factor_internal.h"
#include "cvo_slam/backend/minimize_internal.h"
#include "cvo_slam/backend/robust_loss_internal.h"

namespace cvo_slam {
namespace {

/// Gauss-Newton until it fails: the start is near, and Ceres' own 1e4 costs an iteration or two.
constexpr double kInitialTrustRegionRadius = 1e8;

std::unique_ptr<ceres::LossFunction> make_loss(const OptimizerOptions& options) {
  switch (options.loss) {
    case RobustLoss::kHuber:
      return std::make_unique<ceres::HuberLoss>(options.loss_scale);
    case RobustLoss::kCauchy:
      return std::make_unique<ceres::CauchyLoss>(options.loss_scale);
    case RobustLoss::kNone:
    case RobustLoss::kGnc:
      break;
  }
  return nullptr;
}

ceres::Problem::Options problem_options() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;  // the input is made here
  return options;
}

ceres::Solver::Options solver_options(const OptimizerOptions& options) {
  ceres::Solver::Options ceres_options;
  ceres_options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  ceres_options.sparse_linear_algebra_library_type =
      options.solver == LinearSolver::kEigen ? ceres::EIGEN_SPARSE : ceres::SUITE_SPARSE;
  ceres_options.max_num_iterations = options.max_iterations;
  ceres_options.function_tolerance = options.cost_tolerance;
  ceres_options.initial_trust_region_radius = kInitialTrustRegionRadius;
  // With more threads Ceres adds the costs in the order in which its threads finish.
  ceres_options.num_threads = 1;
  ceres_options.logging_type = ceres::SILENT;
  return ceres_options;
}

MinimizeReport solve(ceres::Problem& problem, const OptimizerOptions& options) {
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(options), &problem, &summary);
  return {static_cast<int>(summary.iterations.size()) - 1,
          summary.termination_type == ceres::CONVERGENCE, summary.message};
}

}  // namespace

bool choose_start(PoseGraph& graph, const OptimizerOptions& options) {
  if (options.initialization == Initialization::kGiven) return false;
  const auto chordal = chordal_initialization(graph);
  if (!chordal) return false;
  PoseGraph moved = graph;
  for (std::size_t i = 0; i < chordal->size(); ++i) moved.set_pose(i, (*chordal)[i]);
  if (options.initialization == Initialization::kAuto &&
      robust_cost(graph, options) <= robust_cost(moved, options)) {
    return false;
  }
  graph = std::move(moved);
  return true;
}

MinimizeReport minimize(PoseGraph& graph, const OptimizerOptions& options) {
  const std::vector<bool> held = graph.held_nodes();
  std::vector<PoseVector> poses;
  poses.reserve(graph.nodes().size());
  for (const PoseGraphNode& node : graph.nodes()) poses.push_back(to_vector(node.T_world_node));

  PoseManifold manifold;
  const auto loss = make_loss(options);
  std::deque<BetweenFactor> factors;  // a factor can be neither copied nor moved
  ceres::Problem problem(problem_options());
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const auto [a, b] = graph.ends()[i];
    if (held[a] && held[b]) continue;
    const PoseGraphEdge& edge = graph.edges()[i];
    factors.emplace_back(edge.T_from_to, edge.information);
    problem.AddResidualBlock(&factors.back(), edge.robust ? loss.get() : nullptr, poses[a].data(),
                             poses[b].data());
  }
  if (factors.empty()) return {0, true, "nothing to move"};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!problem.HasParameterBlock(poses[i].data())) continue;
    problem.SetManifold(poses[i].data(), &manifold);
    if (held[i]) problem.SetParameterBlockConstant(poses[i].data());
  }
  MinimizeReport report = solve(problem, options);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!held[i]) graph.set_pose(i, to_pose(poses[i]));
  }
  return report;
}

}  // namespace cvo_slam
