// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

#include "cvo_slam/loop/descriptor.h"
#include "cvo_slam/loop/feature_matching_internal.h"
#include "cvo_slam/loop/ray_bounds_internal.h"

namespace cvo_slam {
namespace {

/// Returns the descriptors of the features of one node.
std::vector<Descriptor> descriptors_of(const OrbFeatures& features,
                                       std::span<const NodeFeature> members) {
  std::vector<Descriptor> descriptors;
  descriptors.reserve(members.size());
  for (const NodeFeature& member : members) {
    descriptors.push_back(features.descriptors[member.feature]);
  }
  return descriptors;
}

/// The nearest and the second nearest entry of a row or column of a table of distances.
struct TwoNearest {
  int first = std::numeric_limits<int>::max();
  int second = std::numeric_limits<int>::max();
  std::size_t index = 0;

  void see(int distance, std::size_t i) {
    if (distance < first) {
      second = first;
      first = distance;
      index = i;
    } else {
      second = std::min(second, distance);
    }
  }

  [[nodiscard]] bool is_clear(const MatchingOptions& options) const {
    return first <= options.max_distance && first < options.ratio * second;
  }
};

void match_node(const OrbFeatures& a, std::span<const NodeFeature> a_members, const OrbFeatures& b,
                std::span<const NodeFeature> b_members, const MatchingOptions& options,
                std::vector<FeatureMatch>& matches) {
  const std::vector<Descriptor> candidates = descriptors_of(b, b_members);
  std::vector<std::uint16_t> distances(candidates.size());
  std::vector<TwoNearest> rows(a_members.size());
  std::vector<TwoNearest> columns(b_members.size());
  for (std::size_t i = 0; i < a_members.size(); ++i) {
    hamming_distances(a.descriptors[a_members[i].feature], candidates, distances);
    for (std::size_t j = 0; j < distances.size(); ++j) {
      rows[i].see(distances[j], j);
      columns[j].see(distances[j], i);
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].is_clear(options)) continue;
    const TwoNearest& back = columns[rows[i].index];
    if (back.index != i || !back.is_clear(options)) continue;
    matches.push_back({a_members[i].feature, b_members[rows[i].index].feature});
  }
}

/// Returns the features at the head of `members` that belong to the same node.
std::span<const NodeFeature> first_node(std::span<const NodeFeature> members) {
  const auto end = std::find_if(members.begin(), members.end(), [&](const NodeFeature& member) {
    return member.node != members.front().node;
  });
  return {members.begin(), end};
}

/// Returns the rotation between the features of a match, in [0, 2 pi).
double turn_of(const OrbFeatures& a, const OrbFeatures& b, const FeatureMatch& match) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double turn = b.points[match.b].angle - a.points[match.a].angle;
  return turn < 0 ? turn + kTurn : turn;
}

/// Returns the indices of the features in ascending order of rows.
std::vector<std::uint32_t> sorted_by_rows(const OrbFeatures& features) {
  std::vector<std::uint32_t> order(features.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return features.points[i].y < features.points[j].y;
  });
  return order;
}

/// Finds the most similar features of an image near a position.
class RadiusSearch {
 public:
  RadiusSearch(const OrbFeatures& features, const PinholeCamera& camera)
      : features_(features), camera_(camera), order_(sorted_by_rows(features)) {}

  /// Searches around a ray, within `radius` [px]. The result has no index if no feature is there.
  [[nodiscard]] TwoNearest find(const Descriptor& descriptor, const Eigen::Vector2d& ray,
                                double radius) const {
    const double reach = radius / std::abs(camera_.fy);
    const auto at_row = [&](std::uint32_t i, double row) { return features_.points[i].y < row; };
    TwoNearest nearest;
    for (auto i = std::lower_bound(order_.begin(), order_.end(), ray.y() - reach, at_row);
         i != order_.end() && features_.points[*i].y <= ray.y() + reach; ++i) {
      const OrbFeature& feature = features_.points[*i];
      if (std::hypot((feature.x - ray.x()) * camera_.fx, (feature.y - ray.y()) * camera_.fy) >
          radius)
        continue;
      nearest.see(hamming_distance(descriptor, features_.descriptors[*i]), *i);
    }
    return nearest;
  }

 private:
  const OrbFeatures& features_;
  const PinholeCamera& camera_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

std::vector<FeatureMatch> match_by_nodes(const OrbFeatures& a,
                                         const std::vector<NodeFeature>& a_nodes,
                                         const OrbFeatures& b,
                                         const std::vector<NodeFeature>& b_nodes,
                                         const MatchingOptions& options) {
  std::vector<FeatureMatch> matches;
  std::span<const NodeFeature> rest_a(a_nodes);
  std::span<const NodeFeature> rest_b(b_nodes);
  while (!rest_a.empty() && !rest_b.empty()) {
    const auto in_a = first_node(rest_a);
    const auto in_b = first_node(rest_b);
    if (in_a.front().node == in_b.front().node) match_node(a, in_a, b, in_b, options, matches);
    if (in_a.front().node <= in_b.front().node) rest_a = rest_a.subspan(in_a.size());
    if (in_b.front().node <= in_a.front().node) rest_b = rest_b.subspan(in_b.size());
  }
  std::sort(matches.begin(), matches.end());
  return matches;
}

std::vector<FeatureMatch> keep_common_rotation(const OrbFeatures& a, const OrbFeatures& b,
                                               const std::vector<FeatureMatch>& matches,
                                               const MatchingOptions& options) {
  constexpr double kTurn = 2 * std::numbers::pi;
  std::vector<double> turns;
  turns.reserve(matches.size());
  for (const FeatureMatch& match : matches) turns.push_back(turn_of(a, b, match));
  const auto is_near = [&](double turn, double center) {
    return std::abs(std::remainder(turn - center, kTurn)) <= options.rotation_window;
  };
  double center = 0;
  std::ptrdiff_t most = 0;
  for (const double candidate : turns) {
    const auto count = std::count_if(turns.begin(), turns.end(),
                                     [&](double turn) { return is_near(turn, candidate); });
    if (count > most) {
      most = count;
      center = candidate;
    }
  }
  std::vector<FeatureMatch> kept;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (is_near(turns[i], center)) kept.push_back(matches[i]);
  }
  return kept;
}

ProjectionMatches match_by_projection(const OrbFeatures& a, const OrbFeatures& b, const SE3& T_b_a,
                                      const PinholeCamera& camera, const MatchingOptions& options) {
  ProjectionMatches result;
  const RadiusSearch search(b, camera);
  const RayBounds bounds(camera);
  // Each feature of b is matched with the most similar feature of a.
  std::vector<TwoNearest> takers(b.size());
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    if (!a.points[i].has_depth()) continue;
    const Vector3 position = T_b_a * a.points[i].position();
    const Eigen::Vector2d ray = position.head<2>() / position.z();
    if (position.z() <= 0 || !bounds.contains(ray)) continue;
    result.visible.push_back(ray);
    const TwoNearest nearest =
        search.find(a.descriptors[i], ray, options.search_radius * a.points[i].size);
    if (nearest.first <= options.max_distance) takers[nearest.index].see(nearest.first, i);
  }
  for (std::uint32_t j = 0; j < b.size(); ++j) {
    if (takers[j].first > options.max_distance) continue;
    result.matches.push_back({static_cast<std::uint32_t>(takers[j].index), j});
  }
  std::sort(result.matches.begin(), result.matches.end());
  return result;
}

}  // namespace cvo_slam
