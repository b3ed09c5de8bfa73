// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/loop_verifier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "cvo_slam/loop/feature_matching_internal.h"
#include "cvo_slam/loop/pose_search_internal.h"
#include "cvo_slam/loop/ray_bounds_internal.h"

namespace cvo_slam {
namespace {

/// Returns the matches of which at least one side has a depth.
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

/// Returns the largest standard deviation in any direction.
double largest_deviation(const Matrix3& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

/// Number of features in each cell of an image.
class CellCounts {
 public:
  explicit CellCounts(const RayBounds& bounds) : bounds_(bounds) {}

  void add(const Eigen::Vector2d& ray) {
    const Eigen::Vector2d share = bounds_.share(ray);
    const auto column = static_cast<std::size_t>(share.x() * kColumns);
    const auto row = static_cast<std::size_t>(share.y() * kRows);
    ++counts_[row * kColumns + column];
  }

  /// Returns the share of the cells with several visible features that have an inlier.
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

std::vector<FeatureMatch> match_words(const Appearance& a, const Appearance& b,
                                      const MatchingOptions& options) {
  const auto matches =
      match_by_nodes(a.features, a.words.nodes, b.features, b.words.nodes, options);
  return keep_common_rotation(a.features, b.features, matches, options);
}

/// A pose with its inliers, and the features that should be visible in the other image.
struct PoseFit {
  PoseEstimate estimate;
  std::vector<PointPair> inliers;
  ProjectionMatches in_b;  ///< features of a in image b
  ProjectionMatches in_a;  ///< features of b in image a
};

/// Refines a pose on its inliers among `pairs`, matches all features again with that pose, and
/// refines it on the new inliers.
PoseFit fit_pose(const SE3& start, const std::vector<PointPair>& pairs, const Appearance& a,
                 const Appearance& b, const PairModel& model, const PinholeCamera& camera,
                 const MatchingOptions& options) {
  const SE3 coarse = model.refine(start, inliers_of(start, pairs, model)).T_a_b;
  PoseFit fit;
  fit.in_b = match_by_projection(a.features, b.features, coarse.inverse(), camera, options);
  fit.in_a = match_by_projection(b.features, a.features, coarse, camera, options);
  const auto all = pairs_of(a.features, b.features, fit.in_b.matches);
  fit.estimate = model.refine(coarse, inliers_of(coarse, all, model));
  fit.estimate = model.refine(fit.estimate.T_a_b, inliers_of(fit.estimate.T_a_b, all, model));
  fit.inliers = inliers_of(fit.estimate.T_a_b, all, model);
  return fit;
}

/// Returns Verification::inlier_share, of the image with fewer visible features.
double inlier_share(const PoseFit& fit) {
  const auto visible =
      std::max<std::size_t>(1, std::min(fit.in_a.visible.size(), fit.in_b.visible.size()));
  return static_cast<double>(fit.inliers.size()) / static_cast<double>(visible);
}

CellCounts count_cells(const RayBounds& bounds, const std::vector<Eigen::Vector2d>& rays) {
  CellCounts cells(bounds);
  for (const Eigen::Vector2d& ray : rays) cells.add(ray);
  return cells;
}

/// Returns Verification::coverage.
double coverage(const PoseFit& fit, const PinholeCamera& camera) {
  const RayBounds bounds(camera);
  CellCounts inliers_in_a(bounds);
  CellCounts inliers_in_b(bounds);
  for (const PointPair& pair : fit.inliers) {
    inliers_in_a.add(pair.a.ray().head<2>());
    inliers_in_b.add(pair.b.ray().head<2>());
  }
  return std::min(CellCounts::share(inliers_in_a, count_cells(bounds, fit.in_a.visible)),
                  CellCounts::share(inliers_in_b, count_cells(bounds, fit.in_b.visible)));
}

/// Returns why the pose is too uncertain; an empty text if it is not.
std::string uncertainty_problem(const Matrix6& information, const VerificationOptions& options) {
  const Eigen::LDLT<AlignedMatrix6> factors{AlignedMatrix6(information)};
  const AlignedMatrix6 covariance = factors.solve(AlignedMatrix6::Identity());
  const double translation = largest_deviation(covariance.topLeftCorner<3, 3>());
  const double rotation = largest_deviation(covariance.bottomRightCorner<3, 3>());
  if (translation <= options.max_deviation_translation &&
      rotation <= options.max_deviation_rotation) {
    return {};
  }
  return fmt::format("pose uncertain: {:.3f} m, {:.3f} rad; at most {:.3f} m, {:.3f} rad allowed",
                     translation, rotation, options.max_deviation_translation,
                     options.max_deviation_rotation);
}

/// Returns why a pose is rejected; an empty text if it is accepted. `pairs` is the number of
/// matches among which it was searched.
std::string problem_of(const Verification& result, std::size_t pairs,
                       const VerificationOptions& options) {
  if (result.inliers < static_cast<std::size_t>(options.min_inliers)) {
    return fmt::format("{} inliers of {} matches; {} needed", result.inliers, pairs,
                       options.min_inliers);
  }
  if (result.inlier_share < options.min_visible_share) {
    return fmt::format("{:.2f} of the features that both should see match; {:.2f} needed",
                       result.inlier_share, options.min_visible_share);
  }
  if (result.coverage < options.min_coverage) {
    return fmt::format("{:.2f} of the image cells that both should see match; {:.2f} needed",
                       result.coverage, options.min_coverage);
  }
  return uncertainty_problem(result.information, options);
}

Verification rejected(std::size_t matches, std::string reason) {
  Verification result;
  result.matches = matches;
  result.reason = std::move(reason);
  return result;
}

OptionSet describe_matching(MatchingOptions& o) {
  return OptionSet()
      .expert()
      .add("node_level", o.node_level, {0, 16}, "levels",
           "Features are compared if they share the node of the vocabulary this many levels below "
           "the root.")
      .add("max_distance", o.max_distance, {0, 256}, "bits",
           "Largest distance between the descriptors of a match.")
      .add("ratio", o.ratio, {0, 1}, "",
           "Largest ratio of the distances to the nearest and to the second nearest descriptor.")
      .add("rotation_window", o.rotation_window, {0, 3.15}, "rad",
           "Largest difference between the rotation of a match and the most common rotation.")
      .add(
          "search_radius", o.search_radius, {0, 1000}, "px",
          "Radius of the search for a feature around its projection, at the finest pyramid level.");
}

}  // namespace

OptionSet describe(VerificationOptions& o) {
  return OptionSet()
      .add("max_reprojection", o.max_reprojection, {0.1, 100}, "px",
           "Largest distance between a feature and the projection of its match, for an inlier.")
      .add("min_inliers", o.min_inliers, {4, 100000}, "",
           "Least number of inliers of an accepted candidate.")
      .expert()
      .add("matching", describe_matching(o.matching))
      .add("min_matches", o.min_matches, {3, 100000}, "",
           "Least number of matches for which a pose is searched.")
      .add("iterations", o.iterations, {1, 1000000}, "",
           "Most triples of matches from which a pose is computed.")
      .add("min_visible_share", o.min_visible_share, {0, 1}, "",
           "Least share of inliers among the features that both images should see.")
      .add("min_coverage", o.min_coverage, {0, 1}, "",
           "Least share of the cells (10 by 8) in which both images should see features that have "
           "an inlier; below it, the common features may be a single object.")
      .add("max_deviation_translation", o.max_deviation_translation, {0, 100}, "m",
           "Largest standard deviation of the position in any direction.")
      .add("max_deviation_rotation", o.max_deviation_rotation, {0, 4}, "rad",
           "Largest standard deviation of the orientation about any axis.");
}

LoopVerifier::LoopVerifier(const Camera& camera, const VerificationOptions& options)
    : camera_(camera), options_(options) {
  camera_.check();
  describe(options_).check();
}

Verification LoopVerifier::verify(const Appearance& a, const Appearance& b) const {
  const std::vector<FeatureMatch> matches = match_words(a, b, options_.matching);
  if (matches.size() < static_cast<std::size_t>(options_.min_matches)) {
    return rejected(matches.size(), fmt::format("{} features match; {} needed", matches.size(),
                                                options_.min_matches));
  }
  const std::vector<PointPair> pairs = pairs_of(a.features, b.features, matches);
  const PairModel model(camera_, options_.max_reprojection);
  constexpr std::uint64_t kSeed = 1;
  const auto start = search_pose(pairs, model, options_.iterations, Random({kSeed, a.id, b.id}));
  if (!start) return rejected(matches.size(), "no three matches give a pose");
  const PoseFit fit = fit_pose(*start, pairs, a, b, model, camera_.color, options_.matching);
  Verification result{.accepted = false,
                      .reason = {},
                      .T_a_b = fit.estimate.T_a_b,
                      .information = fit.estimate.information,
                      .matches = matches.size(),
                      .inliers = fit.inliers.size(),
                      .inlier_share = inlier_share(fit),
                      .coverage = coverage(fit, camera_.color),
                      .pixels = pixels_of(fit.inliers)};
  result.reason = problem_of(result, pairs.size(), options_);
  result.accepted = result.reason.empty();
  return result;
}

}  // namespace cvo_slam
