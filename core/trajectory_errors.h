// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "cvo_slam/core/association.h"
#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// The figures usually reported for a list of errors, in the unit of the errors (sse: its square).
/// All figures of an empty list but the count are NaN.
struct Statistics {
  std::size_t count = 0;                                   ///< number of errors
  double rmse = std::numeric_limits<double>::quiet_NaN();  ///< root of the mean squared error
  double mean = std::numeric_limits<double>::quiet_NaN();  ///< arithmetic mean
  /// For an even count, the mean of the two middle values.
  double median = std::numeric_limits<double>::quiet_NaN();
  double std = std::numeric_limits<double>::quiet_NaN();  ///< of the population: divided by count
  double min = std::numeric_limits<double>::quiet_NaN();  ///< smallest error
  double max = std::numeric_limits<double>::quiet_NaN();  ///< largest error
  double sse = std::numeric_limits<double>::quiet_NaN();  ///< sum of squared errors
};

/// Returns the statistics of `values`, which must not contain NaN.
[[nodiscard]] Statistics summarize(std::span<const double> values);

/// Returns the same statistics in another unit; `factor` is the size of the old unit in the new
/// one.
[[nodiscard]] Statistics in_unit(const Statistics& statistics, double factor);

/// The error of one pose, or of one pair of poses.
struct PoseError {
  Timestamp stamp;         ///< stamp of the pose, or of the later pose of the pair
  double translation = 0;  ///< [m]
  double rotation = 0;     ///< [rad]
};

/// The statistics of both parts of the errors.
struct PoseErrorStatistics {
  Statistics translation;  ///< [m]
  Statistics rotation;     ///< [rad]
};

/// Returns the statistics of both parts of the errors.
[[nodiscard]] PoseErrorStatistics summarize(const std::vector<PoseError>& errors);

/// The transformations of an estimate that are allowed before its errors are computed.
enum class Alignment {
  kNone,  ///< none: both trajectories are in the same world frame
  kSe3,   ///< rotation and translation
  kSim3,  ///< rotation, translation and scale, for monocular systems
};

/// A similarity transformation: p_reference = R * (scale * p_estimate) + t.
struct Similarity {
  SE3 T_reference_estimate;  ///< R and t
  double scale = 1;          ///< 1 unless the alignment is kSim3

  /// Returns a camera pose in the reference's world: the position is scaled, rotated and moved, the
  /// orientation is rotated.
  [[nodiscard]] SE3 operator*(const SE3& pose) const;
};

/// Returns the alignment that minimises the squared distances between matched positions, in closed
/// form: S. Umeyama, "Least-Squares Estimation of Transformation Parameters Between Two Point
/// Patterns", PAMI 1991, Eqs. (38) to (43). Orientations are not used, as in evo and in the tools
/// of the TUM benchmark. Throws DataError if the answer is not unique: fewer than three matches, or
/// the positions of either side lie on one line or point. kNone returns the identity for any input.
[[nodiscard]] Similarity align_positions(const std::vector<MatchedPose>& matches,
                                         Alignment alignment);

/// Returns the poses of an estimate in the reference's world.
[[nodiscard]] std::vector<StampedPose> transformed(const Similarity& similarity,
                                                   std::vector<StampedPose> poses);

/// Absolute trajectory error (ATE; evo calls it APE): the distance of an estimate from the
/// reference as a whole.
struct AbsoluteTrajectoryError {
  Similarity alignment;            ///< applied to the estimate
  std::vector<PoseError> errors;   ///< one per match, with the stamp of the match
  PoseErrorStatistics statistics;  ///< summary of the errors
};

/// Returns the ATE of poses matched by associate(): with E = T_reference^-1 T_estimate after
/// alignment, the length of its translation and its rotation angle. J. Sturm et al., "A Benchmark
/// for the Evaluation of RGB-D SLAM Systems", IROS 2012, Eq. (4), here with the rotation too.
/// Throws DataError if there is no match or the alignment is not unique.
[[nodiscard]] AbsoluteTrajectoryError absolute_trajectory_error(
    const std::vector<MatchedPose>& matches, Alignment alignment = Alignment::kSe3);

/// The unit in which the distance between the two poses of a pair is given.
enum class DeltaUnit { kFrames, kMetres, kSeconds };

/// Returns "frames", "m" or "s".
[[nodiscard]] std::string_view to_string(DeltaUnit unit);

/// The distance between two relative motions, Q of the reference and P of the estimate, both T_i_j
/// of the later pose j in the earlier pose i.
enum class RelativeErrorKind {
  /// Length of the translation and rotation angle of E = Q^-1 P (Sturm et al., IROS 2012, Eq. (2)).
  kRelativePose,
  /// Length of the translation of P Q^-1, |T1 - R1 R2^T T2|, and |log(R1 R2^T)|_F, which is sqrt(2)
  /// times the rotation angle (Ghaffari et al., RSS 2019, section VI).
  kCvoPaper,
};

/// Which pairs of poses are compared, and how.
struct RelativePoseOptions {
  double delta = 1;  ///< distance of the poses of a pair, > 0; a whole number of frames
  DeltaUnit unit = DeltaUnit::kSeconds;  ///< unit of delta
  /// If true, a pair starts at every pose; otherwise where the last pair ended.
  bool all_pairs = true;
  /// With all pairs over metres: the largest share of delta by which a pair may miss it.
  double relative_tolerance = 0.1;
  /// Over seconds: by how much a pair may be longer than delta [s], or by the usual step from match
  /// to match where that is longer. A larger difference means lost frames.
  double time_tolerance = 0.05;
  /// How the two relative motions of a pair are compared.
  RelativeErrorKind kind = RelativeErrorKind::kRelativePose;
};

/// Returns the options of the CVO paper's own measure: from frame to frame.
[[nodiscard]] constexpr RelativePoseOptions cvo_paper_options() {
  return {.unit = DeltaUnit::kFrames, .all_pairs = false, .kind = RelativeErrorKind::kCvoPaper};
}

/// Returns the indices (i, j), i < j, of the matches whose relative motions are compared:
/// - frames: j = i + delta, counted in matches. Not all pairs: i = 0, delta, 2 delta, ...
/// - metres: distances are measured along the estimate's path. All pairs: j is where the path from
///   i is nearest to delta, if within the tolerance. Not all: the path is cut where at least delta
///   has gathered since the last cut; a pair is two consecutive cuts (what lies before the first
///   cut makes no pair, as in evo)
/// - seconds: j is the first match with t_j >= t_i + delta, if within the tolerance. Not all: the
///   next pair starts at j, or at i + 1 if i has no partner
/// Throws OptionError if delta or a tolerance is impossible.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> select_pairs(
    const std::vector<MatchedPose>& matches, const RelativePoseOptions& options);

/// Relative pose error (RPE): the drift over a distance delta.
struct RelativePoseError {
  std::vector<PoseError> errors;   ///< one per pair, with the stamp of its later pose
  PoseErrorStatistics statistics;  ///< summary of the errors
};

/// Returns the RPE of poses matched by associate(). Throws DataError if no two poses are delta
/// apart, and OptionError as select_pairs() does.
[[nodiscard]] RelativePoseError relative_pose_error(const std::vector<MatchedPose>& matches,
                                                    const RelativePoseOptions& options = {});

/// From which error on a motion is wrong, as no drift is: the tracker has slipped.
struct WrongMotion {
  double translation = 0.10;                     ///< [m]
  double rotation = 5 * std::numbers::pi / 180;  ///< [rad]
};

/// Returns the matches that are wrong, with the error of their motion since the last one that was
/// right; the first one is. What follows a slip is wrong until the estimate is back.
[[nodiscard]] std::vector<PoseError> find_wrong_poses(const std::vector<MatchedPose>& matches,
                                                      const WrongMotion& limits = {});

/// Measures the offset between the clocks of two trajectories: what to add to the estimate's stamps
/// [s], at most half a second, so that the rotations of the RPE over a second are smallest. It is
/// found to a tenth of a millisecond; the reference is interpolated. Empty if the trajectories have
/// no poses a second apart, if the smallest error is at the limit, or if the camera hardly turns,
/// so that no offset is better than others. Throws OptionError for a bad option.
[[nodiscard]] std::optional<double> measure_time_offset(const std::vector<StampedPose>& reference,
                                                        const std::vector<StampedPose>& estimate,
                                                        const AssociationOptions& options = {});

}  // namespace cvo_slam
