// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/SparseCholesky>

#include "cvo_slam/backend/optimizer.h"

namespace cvo_slam {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// The normal equations of the least-squares problem
///   sum over the edges of weight |M_e x_a - x_b + c_e|^2,
/// where each x is a block of `Size` rows and three columns; held blocks are known.
template <int Size>
class BlockLeastSquares {
 public:
  using Block = Eigen::Matrix<double, Size, Size>;
  using Value = Eigen::Matrix<double, Size, 3>;

  explicit BlockLeastSquares(const std::vector<bool>& held) : row_(held.size(), -1) {
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (!held[i]) row_[i] = Size * free_++;
    }
    rhs_ = Columns::Zero(Size * free_, 3);
    diagonal_.assign(static_cast<std::size_t>(free_), Block::Zero());
  }

  /// `known` holds the values of the held blocks.
  void add(std::size_t a, std::size_t b, double weight, const Block& M, const Value& c,
           const std::vector<Value>& known) {
    const Eigen::Index row_a = row_[a];
    const Eigen::Index row_b = row_[b];
    if (row_a >= 0) diagonal_[static_cast<std::size_t>(row_a / Size)] += weight * M.transpose() * M;
    if (row_b >= 0) diagonal_[static_cast<std::size_t>(row_b / Size)] += weight * Block::Identity();
    if (row_a >= 0 && row_b >= 0) add_off_diagonal(row_a, row_b, -weight * M);
    Value constant = c;
    if (row_a < 0) constant += M * known[a];
    if (row_b < 0) constant -= known[b];
    if (row_a >= 0) rhs_.template middleRows<Size>(row_a) -= weight * M.transpose() * constant;
    if (row_b >= 0) rhs_.template middleRows<Size>(row_b) += weight * constant;
  }

  /// Computes the free blocks of `values`. Returns false if they are not determined.
  bool solve(std::vector<Value>& values) {
    for (std::size_t i = 0; i < diagonal_.size(); ++i) {
      add_lower(Size * static_cast<Eigen::Index>(i), Size * static_cast<Eigen::Index>(i),
                diagonal_[i]);
    }
    SparseMatrix normal(rhs_.rows(), rhs_.rows());
    normal.setFromTriplets(lower_.begin(), lower_.end());
    const Eigen::SimplicialLDLT<SparseMatrix> cholesky(normal);
    if (cholesky.info() != Eigen::Success) return false;
    const Columns x = cholesky.solve(rhs_);
    if (!x.allFinite()) return false;
    for (std::size_t i = 0; i < row_.size(); ++i) {
      if (row_[i] >= 0) values[i] = x.template middleRows<Size>(row_[i]);
    }
    return true;
  }

 private:
  /// Adds a block that couples the rows of b with the columns of a.
  void add_off_diagonal(Eigen::Index row_a, Eigen::Index row_b, const Block& block) {
    if (row_b > row_a) {
      add_lower(row_b, row_a, block);
    } else {
      add_lower(row_a, row_b, block.transpose());
    }
  }

  void add_lower(Eigen::Index row, Eigen::Index column, const Block& block) {
    for (int j = 0; j < Size; ++j) {
      for (int i = row == column ? j : 0; i < Size; ++i) {
        lower_.emplace_back(row + i, column + j, block(i, j));
      }
    }
  }

  std::vector<Eigen::Index> row_;  // first row of a free block; -1 if the block is held
  Eigen::Index free_ = 0;
  Columns rhs_;
  std::vector<Block> diagonal_;
  std::vector<Eigen::Triplet<double, Eigen::Index>> lower_;
};

double mean_weight(const Matrix6& information, Eigen::Index first) {
  return information.diagonal().segment<3>(first).mean();
}

/// Solves R_b = R_a R_ab, transposed so that the unknowns are in columns: |R_ab^T R_a^T - R_b^T|.
bool relax_rotations(const PoseGraph& graph, const std::vector<bool>& held,
                     std::vector<Matrix3>& transposed) {
  BlockLeastSquares<3> problem(held);
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const auto [a, b] = graph.ends()[i];
    const PoseGraphEdge& edge = graph.edges()[i];
    problem.add(a, b, mean_weight(edge.information, 3), edge.T_from_to.rotation().transpose(),
                Matrix3::Zero(), transposed);
  }
  return problem.solve(transposed);
}

/// Solves p_b = p_a + R_a p_ab.
bool solve_positions(const PoseGraph& graph, const std::vector<bool>& held,
                     const std::vector<SE3>& rotated, std::vector<Eigen::RowVector3d>& positions) {
  BlockLeastSquares<1> problem(held);
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const auto [a, b] = graph.ends()[i];
    const PoseGraphEdge& edge = graph.edges()[i];
    problem.add(a, b, mean_weight(edge.information, 0), Eigen::Matrix<double, 1, 1>(1),
                (rotated[a].rotation() * edge.T_from_to.translation()).transpose(), positions);
  }
  return problem.solve(positions);
}

SE3 nearest_rotation(const Matrix3& matrix) {
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  T.topLeftCorner<3, 3>() = matrix;
  return SE3::from_matrix(T);
}

}  // namespace

std::optional<std::vector<SE3>> chordal_initialization(const PoseGraph& graph) {
  const std::vector<bool> held = graph.held_nodes();
  std::vector<Matrix3> transposed;
  std::vector<Eigen::RowVector3d> positions;
  std::vector<SE3> poses;
  for (const PoseGraphNode& node : graph.nodes()) {
    transposed.emplace_back(node.T_world_node.rotation().transpose());
    positions.emplace_back(node.T_world_node.translation().transpose());
    poses.push_back(node.T_world_node);
  }
  if (!relax_rotations(graph, held, transposed)) return std::nullopt;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!held[i]) poses[i] = nearest_rotation(transposed[i].transpose());
  }
  if (!solve_positions(graph, held, poses, positions)) return std::nullopt;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!held[i]) poses[i] = SE3(poses[i].rotation(), positions[i].transpose());
  }
  return poses;
}

}  // namespace cvo_slam
