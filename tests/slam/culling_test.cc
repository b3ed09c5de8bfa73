// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Keyframes that the map does without.
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Cholesky>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/slam/culling_internal.h"
#include "cvo_slam/slam/graph_prior_internal.h"
#include "cvo_slam/slam/slam.h"
#include "cvo_slam/tests/frontend/synthetic_frames.h"
#include "cvo_slam/tests/frontend/test_frames.h"
#include "cvo_slam/tests/frontend/tracker_test_options.h"

namespace cvo_slam {
namespace {

constexpr double kTranslationNoise = 0.01;  // [m]; standard deviations of the measurements
constexpr double kRotationNoise = 0.01;     // [rad]

Matrix6 measurement_covariance() {
  Matrix6 covariance = Matrix6::Zero();
  covariance.diagonal().head<3>().setConstant(kTranslationNoise * kTranslationNoise);
  covariance.diagonal().tail<3>().setConstant(kRotationNoise * kRotationNoise);
  return covariance;
}

/// Two rows of keyframes, there and back beside it, with what was measured between neighbours and
/// across, with noise.
class TwoRows {
 public:
  explicit TwoRows(unsigned seed) : random_(seed) {
    for (std::size_t i = 0; i < kKeyframes; ++i) {
      graph_.add_keyframe(i, pose(i));
      if (i > 0) measure(EdgeKind::kOdometry, i - 1, i);
      if (i >= kRow) {
        const std::size_t across = kKeyframes - 1 - i;
        measure(EdgeKind::kProximity, across, i);
        if (across > 0) measure(EdgeKind::kProximity, across - 1, i);
      }
    }
    std::ignore = graph_.optimize(OptimizationScope::kFull);
  }

  static constexpr std::size_t kRow = 8;
  static constexpr std::size_t kKeyframes = 2 * kRow;

  [[nodiscard]] MapGraph& graph() { return graph_; }

  /// The edge between two keyframes at these positions.
  [[nodiscard]] std::size_t edge(std::size_t a, std::size_t b) const {
    for (const std::size_t i : graph_.graph().edges_of(b)) {
      if (graph_.graph().ends()[i] == std::pair(a, b)) return i;
    }
    ADD_FAILURE() << "no edge from " << a << " to " << b;
    return 0;
  }

 private:
  static SE3 pose(std::size_t i) {
    const bool is_back = i >= kRow;
    const double along = 0.2 * static_cast<double>(is_back ? kKeyframes - 1 - i : i);
    return {so3_exp({0, 0.02 * static_cast<double>(i), 0}), {along, is_back ? 0.1 : 0, 0}};
  }
  void measure(EdgeKind kind, std::size_t older, std::size_t newer) {
    std::normal_distribution<double> normal;
    Vector6 error;
    for (int k = 0; k < 6; ++k)
      error[k] = (k < 3 ? kTranslationNoise : kRotationNoise) * normal(random_);
    graph_.add_edge(
        kind, older, newer,
        {pose(older).inverse() * pose(newer) * SE3::exp(error), measurement_covariance()}, {});
  }

  std::mt19937 random_;
  MapGraph graph_{OptimizerOptions()};
};

/// Covariances of right perturbations of the poses, the first of which is held, from the normal
/// equations of the whole graph by central differences.
std::vector<Matrix6> marginal_covariances(const PoseGraph& graph) {
  const auto size = static_cast<Eigen::Index>(6 * graph.nodes().size());
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(size, size);
  constexpr double kStep = 1e-5;
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const PoseGraphEdge& edge = graph.edges()[i];
    const std::array<std::size_t, 2> ends = {graph.ends()[i].first, graph.ends()[i].second};
    std::array<Matrix6, 2> jacobian;
    for (std::size_t end = 0; end < 2; ++end) {
      for (int k = 0; k < 6; ++k) {
        const auto residual = [&](double step) {
          const Vector6 change = step * Vector6::Unit(k);
          std::array<SE3, 2> poses = {graph.nodes()[ends[0]].T_world_node,
                                      graph.nodes()[ends[1]].T_world_node};
          poses[end] = poses[end] * SE3::exp(change);
          return between_residual(poses[0], poses[1], edge.T_from_to);
        };
        jacobian[end].col(k) = (residual(kStep) - residual(-kStep)) / (2 * kStep);
      }
    }
    for (std::size_t a = 0; a < 2; ++a) {
      for (std::size_t b = 0; b < 2; ++b) {
        hessian.block<6, 6>(static_cast<Eigen::Index>(6 * ends[a]),
                            static_cast<Eigen::Index>(6 * ends[b])) +=
            jacobian[a].transpose() * edge.information * jacobian[b];
      }
    }
  }
  const Eigen::MatrixXd covariance = hessian.bottomRightCorner(size - 6, size - 6).inverse();
  std::vector<Matrix6> blocks = {Matrix6::Zero()};
  for (Eigen::Index i = 0; i + 6 < size; i += 6) blocks.emplace_back(covariance.block<6, 6>(i, i));
  return blocks;
}

TEST(ReplacedKeyframe, OfAChainLosesNothing) {
  MapGraph graph{OptimizerOptions()};
  std::vector<SE3> steps;
  for (std::size_t i = 0; i < 4; ++i) {
    graph.add_keyframe(i, SE3());
    if (i == 0) continue;
    Vector6 tangent;
    tangent << 0.2, -0.1, 0.05, 0.1, 0.05 * static_cast<double>(i), -0.2;
    steps.push_back(SE3::exp(tangent));
    graph.add_edge(EdgeKind::kOdometry, i - 1, i,
                   {steps.back(), static_cast<double>(i) * measurement_covariance()}, {});
  }
  const Matrix6 expected = PathSearch(graph, 0).covariance_to(3).value();
  graph.replace_keyframe(1, 0);
  graph.replace_keyframe(1, 0);  // what was the third
  ASSERT_EQ(graph.graph().edges().size(), 1U);
  const PoseGraphEdge& edge = graph.graph().edges()[0];
  EXPECT_EQ(edge.from, 0);
  EXPECT_EQ(edge.to, 3);
  EXPECT_EQ(edge.kind, EdgeKind::kOdometry);
  EXPECT_LT((edge.T_from_to.inverse() * steps[0] * steps[1] * steps[2]).log().norm(), 1e-12);
  EXPECT_LT((PathSearch(graph, 0).covariance_to(1).value() - expected).norm(),
            1e-9 * expected.norm());
}

// What culling may do to the rest of the map: less than the map does not know anyway.
TEST(ReplacedKeyframe, TheOptimumMovesByLessThanItsUncertainty) {
  constexpr std::size_t kRow = TwoRows::kRow;
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    TwoRows rows(seed);
    const PoseGraph all = rows.graph().graph();
    const auto covariances = marginal_covariances(all);
    // Every second one of the way back; later positions first, so that the others stay.
    for (std::size_t i = TwoRows::kKeyframes - 2; i >= kRow; i -= 2) {
      rows.graph().replace_keyframe(i, rows.edge(TwoRows::kKeyframes - 1 - i, i));
    }
    const PoseGraph& culled = rows.graph().graph();
    ASSERT_EQ(culled.nodes().size(), TwoRows::kKeyframes - kRow / 2);
    EXPECT_THAT(culled.components(), testing::Each(0U));
    std::ignore = rows.graph().optimize(OptimizationScope::kFull);
    double sum = 0;
    for (const PoseGraphNode& node : culled.nodes()) {
      const std::size_t i = all.index_of(node.id);
      if (i == 0) continue;
      const Vector6 moved = (all.nodes()[i].T_world_node.inverse() * node.T_world_node).log();
      const double squared = moved.dot(covariances[i].ldlt().solve(moved));
      EXPECT_LT(squared, 6) << "node " << node.id << " of seed " << seed
                            << ": the mean of chi-square";
      sum += squared;
    }
    EXPECT_LT(sum / static_cast<double>(culled.nodes().size() - 1), 3) << "seed " << seed;
  }
}

TEST(ReplacedKeyframe, NothingIsMeasuredTwice) {
  TwoRows rows(1);
  constexpr std::size_t kRow = TwoRows::kRow;
  // Keyframe 8 is measured to 7 twice, by odometry and across, to 6 and to 9; 7 to 6 and 9... too.
  rows.graph().replace_keyframe(kRow, rows.edge(kRow - 1, kRow));
  const PoseGraph& graph = rows.graph().graph();
  EXPECT_FALSE(graph.has_node(kRow));
  std::size_t edges_to_6 = 0;
  for (const std::size_t i : graph.edges_of(kRow - 1)) {
    edges_to_6 += graph.ends()[i].first == kRow - 2 ? 1 : 0;
  }
  EXPECT_EQ(edges_to_6, 1U) << "it was measured there already";
  EXPECT_TRUE(graph.has_edge(kRow - 1, kRow + 1)) << "odometry goes on";
}

/// A camera that goes the same way there and back again and again.
class ManyPasses : public testing::Test {
 protected:
  static constexpr std::size_t kTurn = 20;

  ManyPasses() {
    slam_.tracker = tracker_test_options();
    slam_.loops.detection.candidates.min_gap = 10;
    // Keyframes so near to one another that this short walk makes a map of them.
    slam_.tracker.keyframe = {.min_overlap = 0.5, .max_translation = 0.05, .max_rotation = 0.06};
  }

  static void SetUpTestSuite() {
    const SyntheticFrames walk{small_camera(320, 240)};
    frames_.clear();
    for (std::size_t i = 0; i <= kTurn; ++i) frames_.push_back(walk.frame(i, i));
  }
  static void TearDownTestSuite() { frames_.clear(); }

  static std::size_t place(std::size_t index) {
    const std::size_t phase = index % (2 * kTurn);
    return phase <= kTurn ? phase : 2 * kTurn - phase;
  }
  static void track(Slam& slam, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      RgbdFrame frame = frames_[place(i)];
      frame.index = i;
      frame.stamp = frame.depth_stamp = Timestamp::from_seconds(0.05 * static_cast<double>(i));
      ASSERT_EQ(slam.track(frame).status, TrackingStatus::kTracked) << i;
    }
  }
  [[nodiscard]] Slam make_slam() const { return Slam(small_camera(320, 240), slam_); }

  static inline std::vector<RgbdFrame> frames_;
  SlamOptions slam_;
};

TEST_F(ManyPasses, TheMapStopsGrowing) {
  Slam slam = make_slam();
  track(slam, 0, 9 * kTurn);
  const std::size_t keyframes = slam.keyframes().size();
  const std::size_t edges = slam.pose_graph().edges().size();
  track(slam, 9 * kTurn, 15 * kTurn);
  EXPECT_LE(slam.keyframes().size(), keyframes + 1);
  EXPECT_LE(slam.pose_graph().edges().size(), edges + edges / 20);
  EXPECT_GT(slam.statistics().redundant_keyframes, keyframes);
  EXPECT_EQ(slam.statistics().dropped_keyframes, 0U);
  // Frames keep their poses when their keyframes go.
  const Trajectory trajectory = slam.trajectory();
  ASSERT_EQ(trajectory.poses.size(), 15 * kTurn);
  const SyntheticFrames walk{small_camera(320, 240)};
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    const SE3 error =
        walk.T_first_camera(0, place(i)).inverse() * trajectory.poses[i].T_world_camera;
    EXPECT_LT(error.translation().norm(), 0.02) << i << ": three pixels at 2 m";
  }
  // A map without them is complete.
  const Map map = slam.map();
  EXPECT_EQ(map.memory->keyframes.size(), map.graph.nodes().size());
  const Slam again(map, slam_);
  EXPECT_EQ(again.keyframes().size(), slam.keyframes().size());
}

TEST_F(ManyPasses, SwitchedOffItGrows) {
  slam_.culling.enabled = false;
  Slam slam = make_slam();
  track(slam, 0, 3 * kTurn);
  const std::size_t keyframes = slam.keyframes().size();
  track(slam, 3 * kTurn, 6 * kTurn);
  EXPECT_GT(slam.keyframes().size(), keyframes + keyframes / 2);
  EXPECT_EQ(slam.statistics().redundant_keyframes, 0U);
}

TEST_F(ManyPasses, MemoryIsBounded) {
  Slam all = make_slam();
  track(all, 0, 6 * kTurn);
  // The newest 20 of some 30 stay.
  slam_.culling.max_memory =
      0.9 * static_cast<double>(all.statistics().keyframe_bytes) / (1024 * 1024);
  Slam slam = make_slam();
  track(slam, 0, 6 * kTurn);
  EXPECT_LT(static_cast<double>(slam.statistics().keyframe_bytes),
            slam_.culling.max_memory * 1024 * 1024);
  EXPECT_GT(slam.statistics().dropped_keyframes, 0U);
  EXPECT_EQ(slam.trajectory().poses.size(), 6 * kTurn);
  EXPECT_THAT(slam.pose_graph().components(), testing::Each(0U));
}

TEST_F(ManyPasses, SameResultPipelined) {
  Slam first = make_slam();
  track(first, 0, 6 * kTurn);
  slam_.schedule = Schedule::kPipelined;
  slam_.tracker.threads = 2;
  Slam other = make_slam();
  track(other, 0, 6 * kTurn);
  const auto a = first.trajectory().poses;
  const auto b = other.trajectory().poses;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].T_world_camera.matrix(), b[i].T_world_camera.matrix()) << i;
  }
  EXPECT_EQ(first.keyframes().size(), other.keyframes().size());
}

}  // namespace
}  // namespace cvo_slam
