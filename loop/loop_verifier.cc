// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/loop_verifier.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "cvo_slam/loop/feature_matching_internal.h"
#include "cvo_slam/loop/pose_search_internal.h"
#include "cvo_slam/loop/ray_bounds_internal.h"

namespace cvo_slam {
namespace {

/// The matches of which at least one side has a depth.
std::vector<PointPair> pairs_of(const OrbFeatures& a, const OrbFeatures& b,
                                const std::vector<FeatureMatch>& matches) {
  std::vector<PointPair> pairs;
  for (const FeatureMatch& match : matches) {
    const PointPair pair{a.points[match.a], b.points[match.b]};
    if (pair.a.has_depth() || pair.b.has_depth()) pairs.push_back(pair);
  }
  return pairs;
}

std::vector<PixelPair> pixels_of(const std::vector<PointPair>& pairs) {
  std::vector<PixelPair> pixels;
  pixels.reserve(pairs.size());
  for (const PointPair& pair : pairs) pixels.push_back({pair.a.u, pair.a.v, pair.b.u, pair.b.v});
  return pixels;
}

/// The largest standard deviation of a position or an angle in any direction, the others unknown.
double largest_deviation(const Matrix3& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

/// Counts of the features in each cell of an image.
class CellCounts {
 public:
  explicit CellCounts(const RayBounds& bounds) : bounds_(bounds) {}

  void add(const Eigen::Vector2d& ray) {
    const Eigen::Vector2d share = bounds_.share(ray);
    const auto column = static_cast<std::size_t>(share.x() * kColumns);
    const auto row = static_cast<std::size_t>(share.y() * kRows);
    ++counts_[row * kColumns + column];
  }

  /// Of the cells with several visible features, the share with an inlier.
  static double share(const CellCounts& inliers, const CellCounts& visible) {
    constexpr int kSeveral = 4;
    int cells = 0;
    int explained = 0;
    for (std::size_t i = 0; i < kCells; ++i) {
      if (visible.counts_[i] < kSeveral) continue;
      ++cells;
      explained += inliers.counts_[i] > 0 ? 1 : 0;
    }
    return cells > 0 ? static_cast<double>(explained) / cells : 0;
  }

 private:
  static constexpr std::size_t kColumns = 10;
  static constexpr std::size_t kRows = 8;
  static constexpr std::size_t kCells = kColumns * kRows;

  const RayBounds& bounds_;
  std::array<int, kCells> counts_{};
};

/// The steps of one verification.
class Trial {
 public:
  Trial(const Appearance& a, const Appearance& b, const PinholeCamera& camera,
        const VerificationOptions& options)
      : a_(a),
        b_(b),
        camera_(camera),
        options_(options),
        bounds_(camera),
        model_(camera, options) {}

  Verification run() {
    result_.reason = problem();
    result_.accepted = result_.reason.empty();
    return std::move(result_);
  }

 private:
  /// Why the pair is not accepted.
  std::string problem() {
    const std::vector<PointPair> pairs = match_words();
    if (result_.matches < static_cast<std::size_t>(options_.min_matches)) {
      return fmt::format("{} features match; {} needed", result_.matches, options_.min_matches);
    }
    const auto start =
        search_pose(pairs, model_, options_.iterations,
                    Random({static_cast<std::uint64_t>(options_.seed), a_.id, b_.id}));
    if (!start) return "no three matches give a pose";
    const std::vector<PointPair> inliers = refine(*start, pairs);
    result_.pixels = pixels_of(inliers);
    result_.inliers = inliers.size();
    if (inliers.size() < static_cast<std::size_t>(options_.min_inliers)) {
      return fmt::format("{} inliers of {} matches; {} needed", inliers.size(), pairs.size(),
                         options_.min_inliers);
    }
    if (result_.visible_share < options_.min_visible_share) {
      return fmt::format("{:.2f} of the features that both should see match; {:.2f} needed",
                         result_.visible_share, options_.min_visible_share);
    }
    if (result_.coverage < options_.min_coverage) {
      return fmt::format("{:.2f} of the image cells that both should see match; {:.2f} needed",
                         result_.coverage, options_.min_coverage);
    }
    return uncertainty();
  }

  std::vector<PointPair> match_words() {
    const auto& matching = options_.matching;
    const auto matches = keep_common_rotation(
        a_.features, b_.features,
        match_by_nodes(a_.features, a_.words.nodes, b_.features, b_.words.nodes, matching),
        matching);
    result_.matches = matches.size();
    return pairs_of(a_.features, b_.features, matches);
  }

  /// The inliers of the pose that least squares find on them, after matching with the pose known.
  std::vector<PointPair> refine(const SE3& start, const std::vector<PointPair>& pairs) {
    const SE3 coarse = model_.refine(start, inliers_of(start, pairs, model_)).T_a_b;
    const auto projected =
        match_by_projection(a_.features, b_.features, coarse.inverse(), camera_, options_.matching);
    const auto back =
        match_by_projection(b_.features, a_.features, coarse, camera_, options_.matching);
    const auto all = pairs_of(a_.features, b_.features, projected.matches);
    PoseEstimate fine = model_.refine(coarse, inliers_of(coarse, all, model_));
    fine = model_.refine(fine.T_a_b, inliers_of(fine.T_a_b, all, model_));
    result_.T_a_b = fine.T_a_b;
    result_.information = fine.information;
    auto inliers = inliers_of(fine.T_a_b, all, model_);
    judge_visibility(projected, back, inliers);
    return inliers;
  }

  /// What the pose explains of what both images should see; of the two the worse.
  void judge_visibility(const ProjectionMatches& in_b, const ProjectionMatches& in_a,
                        const std::vector<PointPair>& inliers) {
    const auto visible =
        std::max<std::size_t>(1, std::min(in_a.visible.size(), in_b.visible.size()));
    result_.visible_share = static_cast<double>(inliers.size()) / static_cast<double>(visible);
    CellCounts inliers_in_a(bounds_);
    CellCounts inliers_in_b(bounds_);
    for (const PointPair& pair : inliers) {
      inliers_in_a.add(pair.a.ray().head<2>());
      inliers_in_b.add(pair.b.ray().head<2>());
    }
    result_.coverage = std::min(CellCounts::share(inliers_in_a, visible_cells(in_a)),
                                CellCounts::share(inliers_in_b, visible_cells(in_b)));
  }

  [[nodiscard]] CellCounts visible_cells(const ProjectionMatches& projected) const {
    CellCounts cells(bounds_);
    for (const Eigen::Vector2d& ray : projected.visible) cells.add(ray);
    return cells;
  }

  [[nodiscard]] std::string uncertainty() const {
    const Eigen::LDLT<AlignedMatrix6> factors{AlignedMatrix6(result_.information)};
    const AlignedMatrix6 covariance = factors.solve(AlignedMatrix6::Identity());
    const double translation = largest_deviation(covariance.topLeftCorner<3, 3>());
    const double rotation = largest_deviation(covariance.bottomRightCorner<3, 3>());
    if (translation <= options_.max_deviation_translation &&
        rotation <= options_.max_deviation_rotation) {
      return {};
    }
    return fmt::format("pose uncertain: {:.3f} m, {:.3f} rad; at most {:.3f} m, {:.3f} rad allowed",
                       translation, rotation, options_.max_deviation_translation,
                       options_.max_deviation_rotation);
  }

  const Appearance& a_;
  const Appearance& b_;
  const PinholeCamera& camera_;
  const VerificationOptions& options_;
  RayBounds bounds_;
  PairModel model_;
  Verification result_;
};

}  // namespace

LoopVerifier::LoopVerifier(const PinholeCamera& camera, const VerificationOptions& options)
    : camera_(camera), options_(options) {
  camera_.check();
  describe(options_).check();
}

Verification LoopVerifier::verify(const Appearance& a, const Appearance& b) const {
  return Trial(a, b, camera_, options_).run();
}

}  // namespace cvo_slam
