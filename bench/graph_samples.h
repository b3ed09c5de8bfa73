// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// Returns a tangent vector with normally distributed coordinates of the given standard deviations
/// [m] and [rad].
inline Vector6 random_tangent(std::mt19937& rng, double translation, double rotation) {
  std::normal_distribution<double> normal;
  Vector6 xi;
  for (int k = 0; k < 6; ++k) xi[k] = (k < 3 ? translation : rotation) * normal(rng);
  return xi;
}

/// A graph with its true poses.
struct SampleGraph {
  PoseGraph graph;  ///< at poses chained from the odometry, which has drifted
  std::vector<SE3> truth;
};

/// Returns the graph of a camera that goes three times round a circle on a slope, with `per_round`
/// nodes a round. Odometry leads from each node to the next, loops, flagged robust, to the same
/// place of the round before. Noise is normal with standard deviations of 1 cm and 0.01 rad, and
/// the information matrices are its inverse covariances.
inline SampleGraph make_rounds(int per_round, unsigned seed) {
  constexpr double kSigma = 0.01;
  std::mt19937 rng(seed);
  SampleGraph sample;
  const int count = 3 * per_round;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / per_round;
    sample.truth.emplace_back(so3_exp({0, 0.1 * std::sin(angle), angle}),
                              Vector3(2 * std::cos(angle), 2 * std::sin(angle), 0.05 * i));
  }
  const auto measure = [&](int from, int to, EdgeKind kind) {
    const auto a = static_cast<std::size_t>(from);
    const auto b = static_cast<std::size_t>(to);
    const SE3 T =
        sample.truth[a].inverse() * sample.truth[b] * SE3::exp(random_tangent(rng, kSigma, kSigma));
    return PoseGraphEdge{
        from, to, T, Matrix6::Identity() / (kSigma * kSigma), kind, kind == EdgeKind::kLoop};
  };
  sample.graph.add_node({0, sample.truth[0]});
  for (int i = 1; i < count; ++i) {
    const PoseGraphEdge edge = measure(i - 1, i, EdgeKind::kOdometry);
    sample.graph.add_node({i, sample.graph.nodes().back().T_world_node * edge.T_from_to});
    sample.graph.add_edge(edge);
  }
  for (int i = per_round; i < count; ++i) {
    sample.graph.add_edge(measure(i - per_round, i, EdgeKind::kLoop));
  }
  return sample;
}

/// Adds false loops as ambiguous places cause them: the measurement of one of the loops, between
/// two random nodes. Adds `share` times as many of them as there are loops.
inline void add_false_loops(PoseGraph& graph, double share, unsigned seed) {
  std::vector<PoseGraphEdge> loops;
  for (const PoseGraphEdge& edge : graph.edges()) {
    if (edge.kind == EdgeKind::kLoop) loops.push_back(edge);
  }
  std::mt19937 rng(seed);
  const auto pick = [&](std::size_t size) { return static_cast<std::size_t>(rng() % size); };
  const auto count = std::lround(share * static_cast<double>(loops.size()));
  for (long i = 0; i < count; ++i) {
    PoseGraphEdge edge = loops[pick(loops.size())];
    const std::size_t from = pick(graph.nodes().size());
    const std::size_t to = (from + 1 + pick(graph.nodes().size() - 1)) % graph.nodes().size();
    edge.from = graph.nodes()[from].id;
    edge.to = graph.nodes()[to].id;
    graph.add_edge(edge);
  }
}

/// Returns the root mean square distance of the positions from reference positions [m].
inline double position_rmse(const PoseGraph& graph, const std::vector<SE3>& reference) {
  double sum = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    sum += (graph.nodes()[i].T_world_node.translation() - reference[i].translation()).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(reference.size()));
}

inline std::vector<SE3> poses_of(const PoseGraph& graph) {
  std::vector<SE3> poses;
  for (const PoseGraphNode& node : graph.nodes()) poses.push_back(node.T_world_node);
  return poses;
}

}  // namespace cvo_slam
