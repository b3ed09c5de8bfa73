// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/marginal_covariances.h"

#include <Eigen/SparseCholesky>

#include "cvo_slam/backend/between_factor_internal.h"
#include "cvo_slam/backend/pose_manifold_internal.h"
#include "cvo_slam/backend/weighted_graph_internal.h"
#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;
using Jacobian = Eigen::Matrix<double, 6, 6>;

/// A pivot below this share of the largest is rounding: nothing determines its direction.
constexpr double kSmallestPivot = 1e-14;

/// From derivatives by the values of a pose to those by its tangent.
Jacobian by_tangent(const PoseJacobian& jacobian, const PoseVector& pose) {
  Eigen::Matrix<double, 7, 6, Eigen::RowMajor> plus;
  PoseManifold().PlusJacobian(pose.data(), plus.data());
  return jacobian * plus;
}

/// Adds J_row^T J_column where both nodes are free (row >= 0).
void add_block(Triplets& triplets, int row, int column, const Jacobian& J_row,
               const Jacobian& J_column) {
  if (row < 0 || column < 0) return;
  const Jacobian block = J_row.transpose() * J_column;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) triplets.emplace_back(row + i, column + j, block(i, j));
  }
}

void add_edge(Triplets& triplets, const PoseGraph& graph, std::size_t index,
              const std::vector<int>& row) {
  const auto [a, b] = graph.ends()[index];
  const PoseGraphEdge& edge = graph.edges()[index];
  const PoseVector pose_a = to_vector(graph.nodes()[a].T_world_node);
  const PoseVector pose_b = to_vector(graph.nodes()[b].T_world_node);
  LinearizedEdge linearized;
  BetweenFactor(edge.T_from_to, edge.information).linearize(pose_a, pose_b, linearized);
  const Jacobian J_a = by_tangent(linearized.jacobian_a, pose_a);
  const Jacobian J_b = by_tangent(linearized.jacobian_b, pose_b);
  add_block(triplets, row[a], row[a], J_a, J_a);
  add_block(triplets, row[a], row[b], J_a, J_b);
  add_block(triplets, row[b], row[a], J_b, J_a);
  add_block(triplets, row[b], row[b], J_b, J_b);
}

}  // namespace

struct MarginalCovariances::Impl {
  PoseGraph graph;
  std::vector<int> row;  // of a node's first unknown; -1: held
  int unknowns = 0;
  Eigen::SimplicialLDLT<SparseMatrix> cholesky;

  void factorize() {
    const std::vector<bool> held = graph.held_nodes();
    for (const bool is_held : held) {
      row.push_back(is_held ? -1 : unknowns);
      if (!is_held) unknowns += 6;
    }
    if (unknowns == 0) return;
    Triplets triplets;
    for (std::size_t i = 0; i < graph.edges().size(); ++i) add_edge(triplets, graph, i, row);
    SparseMatrix hessian(unknowns, unknowns);
    hessian.setFromTriplets(triplets.begin(), triplets.end());
    cholesky.compute(hessian);
    const bool determined =
        cholesky.info() == Eigen::Success &&
        cholesky.vectorD().minCoeff() > kSmallestPivot * cholesky.vectorD().maxCoeff();
    if (!determined) {
      throw DataError("the graph's edges do not determine all poses; no covariances");
    }
  }

  /// The columns of the covariance that belong to a node; of a held one zeros.
  [[nodiscard]] Eigen::MatrixXd columns_of(std::size_t node) const {
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(unknowns, 6);
    if (row[node] < 0) return unit;
    unit.middleRows<6>(row[node]).setIdentity();
    return cholesky.solve(unit);
  }

  [[nodiscard]] Matrix6 block(const Eigen::MatrixXd& columns, std::size_t node) const {
    if (row[node] < 0) return Matrix6::Zero();
    return columns.middleRows<6>(row[node]);
  }
};

MarginalCovariances::MarginalCovariances(const PoseGraph& graph, const std::vector<double>& weights)
    : impl_(std::make_unique<Impl>()) {
  impl_->graph = weights.empty() ? graph : weighted_graph(graph, weights);
  impl_->factorize();
}

MarginalCovariances::~MarginalCovariances() = default;
MarginalCovariances::MarginalCovariances(MarginalCovariances&&) noexcept = default;
MarginalCovariances& MarginalCovariances::operator=(MarginalCovariances&&) noexcept = default;

Matrix6 MarginalCovariances::of(NodeId node) const {
  const std::size_t index = impl_->graph.index_of(node);
  return impl_->block(impl_->columns_of(index), index);
}

Matrix6 MarginalCovariances::between(NodeId a, NodeId b) const {
  const std::size_t i = impl_->graph.index_of(a);
  const std::size_t j = impl_->graph.index_of(b);
  const Eigen::MatrixXd of_a = impl_->columns_of(i);
  const Matrix6 aa = impl_->block(of_a, i);
  const Matrix6 ba = impl_->block(of_a, j);
  const Matrix6 bb = impl_->block(impl_->columns_of(j), j);
  // exp(-xi_a) T_ab exp(xi_b) = T_ab exp(xi_b - Ad(T_ba) xi_a) to first order.
  const auto& nodes = impl_->graph.nodes();
  const Matrix6 Ad = (nodes[j].T_world_node.inverse() * nodes[i].T_world_node).adjoint();
  const Matrix6 cross = Ad * ba.transpose();
  return bb - cross - cross.transpose() + Ad * aa * Ad.transpose();
}

}  // namespace cvo_slam
