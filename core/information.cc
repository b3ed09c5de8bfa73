// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/information.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace cvo_slam {
namespace {

/// What sums in another order, or a file with ten digits, may do to a symmetric matrix.
constexpr double kRounding = 1e-9;

}  // namespace

std::string information_problem(const Matrix6& information) {
  if (!information.allFinite()) return "has values that are not finite numbers";
  const double size = information.cwiseAbs().maxCoeff();
  if ((information - information.transpose()).cwiseAbs().maxCoeff() > kRounding * size) {
    return "is not symmetric";
  }
  // The factorisation is fifty times as fast as the eigenvalues, and nearly always enough.
  if (Eigen::LLT<AlignedMatrix6>(information).info() == Eigen::Success) return {};
  const Eigen::SelfAdjointEigenSolver<AlignedMatrix6> eigen(information, Eigen::EigenvaluesOnly);
  if (eigen.eigenvalues().minCoeff() < -kRounding * size) return "has a negative eigenvalue";
  return {};
}

Matrix6 square_root_of_information(const Matrix6& information) {
  const Eigen::LLT<AlignedMatrix6> cholesky(information);
  if (cholesky.info() == Eigen::Success) return cholesky.matrixU();
  const Eigen::SelfAdjointEigenSolver<AlignedMatrix6> eigen(information);
  return eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

Matrix6 edge_information(const SE3& T_from_to, const Matrix6& information) {
  // To first order T exp([v; w]) moves the estimate by R v and turns it by R w, both seen in the
  // frame `from`; the residual has the measurement's rotation relative to the estimate's: -R w.
  Matrix6 residual_of_tangent = Matrix6::Zero();
  residual_of_tangent.topLeftCorner<3, 3>() = T_from_to.rotation();
  residual_of_tangent.bottomRightCorner<3, 3>() = -T_from_to.rotation();
  return residual_of_tangent * information * residual_of_tangent.transpose();
}

}  // namespace cvo_slam
