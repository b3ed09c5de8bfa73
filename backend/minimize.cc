// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>
#include <vector>

#include <ceres/evaluation_callback.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>

#include "cvo_slam/backend/between_factor_internal.h"
#include "cvo_slam/backend/minimize_internal.h"
#include "cvo_slam/backend/pose_manifold_internal.h"
#include "cvo_slam/core/parallel.h"

namespace cvo_slam {
namespace {

/// Edges of one chunk; a chunk is some 30 microseconds of work.
constexpr std::size_t kEdgesPerChunk = 128;

/// Gauss-Newton until that fails: the start is near, and Ceres' own 1e4 costs an iteration or two.
constexpr double kInitialTrustRegionRadius = 1e8;

/// Hands to Ceres what was computed before. With more than one thread Ceres adds the costs in the
/// order in which its threads finish; so it gets one, and ours evaluate the edges.
class PreparedCost final : public ceres::SizedCostFunction<6, 7, 7> {
 public:
  explicit PreparedCost(const LinearizedEdge& edge) : edge_(edge) {}

  bool Evaluate(const double* const* /*parameters*/, double* residuals,
                double** jacobians) const override {
    std::copy_n(edge_.residual.data(), edge_.residual.size(), residuals);
    if (jacobians == nullptr) return true;
    copy(edge_.jacobian_a, jacobians[0]);
    copy(edge_.jacobian_b, jacobians[1]);
    return true;
  }

 private:
  static void copy(const PoseJacobian& jacobian, double* out) {
    if (out != nullptr) std::copy_n(jacobian.data(), jacobian.size(), out);
  }

  const LinearizedEdge& edge_;
};

/// Evaluates all edges when Ceres is about to ask for them.
class EdgeEvaluator final : public ceres::EvaluationCallback {
 public:
  EdgeEvaluator(const std::vector<PoseVector>& poses, int threads)
      : poses_(poses), executor_(threads) {}

  void add(std::size_t a, std::size_t b, const BetweenFactor& factor) {
    edges_.push_back({a, b, factor});
  }
  /// To be called when all edges are there; the costs refer to this object.
  std::vector<PreparedCost> make_costs() {
    linearized_.resize(edges_.size());
    return {linearized_.begin(), linearized_.end()};
  }

  void PrepareForEvaluation(bool evaluate_jacobians, bool new_evaluation_point) override {
    if (!evaluate_jacobians && !new_evaluation_point) return;
    executor_.for_each_chunk(edges_.size(), kEdgesPerChunk,
                             [&](std::size_t /*chunk*/, std::size_t begin, std::size_t end) {
                               for (std::size_t i = begin; i < end; ++i) {
                                 evaluate(i, evaluate_jacobians);
                               }
                             });
  }

 private:
  struct Edge {
    std::size_t a;
    std::size_t b;
    BetweenFactor factor;
  };

  void evaluate(std::size_t i, bool with_jacobians) {
    const Edge& edge = edges_[i];
    const PoseVector& a = poses_[edge.a];
    const PoseVector& b = poses_[edge.b];
    if (with_jacobians) {
      edge.factor.linearize(a, b, linearized_[i]);
    } else {
      linearized_[i].residual = edge.factor.residual(a, b);
    }
  }

  const std::vector<PoseVector>& poses_;
  Executor executor_;
  std::vector<Edge> edges_;
  std::vector<LinearizedEdge> linearized_;
};

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

ceres::Problem::Options problem_options(ceres::EvaluationCallback& callback) {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;  // of an input that is made here
  options.evaluation_callback = &callback;
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

MinimizeReport minimize(PoseGraph& graph, const OptimizerOptions& options) {
  const std::vector<bool> held = graph.held_nodes();
  std::vector<PoseVector> poses;
  poses.reserve(graph.nodes().size());
  for (const PoseGraphNode& node : graph.nodes()) poses.push_back(to_vector(node.T_world_node));

  EdgeEvaluator evaluator(poses, options.threads);
  std::vector<std::size_t> edges;  // that some pose can change
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const auto [a, b] = graph.ends()[i];
    if (held[a] && held[b]) continue;
    evaluator.add(a, b, BetweenFactor(graph.edges()[i].T_from_to, graph.edges()[i].information));
    edges.push_back(i);
  }
  if (edges.empty()) return {0, true, "nothing to move"};

  std::vector<PreparedCost> costs = evaluator.make_costs();
  PoseManifold manifold;
  const auto loss = make_loss(options);
  ceres::Problem problem(problem_options(evaluator));
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto [a, b] = graph.ends()[edges[k]];
    problem.AddResidualBlock(&costs[k], graph.edges()[edges[k]].robust ? loss.get() : nullptr,
                             poses[a].data(), poses[b].data());
  }
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
