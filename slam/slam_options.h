// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/loop/loop_detector.h"

namespace cvo_slam {

/// Where the work on the map is done.
enum class Schedule {
  kInline,     ///< within track()
  kPipelined,  ///< in a thread of its own, while the next frames are tracked
};

/// How a keyframe is registered to an earlier one, and when the result is believed.
struct PairOptions {
  /// Least overlap, in [0, 1]. More than the tracker asks for: a graph can do without a constraint,
  /// the tracker cannot do without a frame; and with less in common the errors of the depth differ
  /// more between the two views. Lower it to get more edges where keyframes are far apart.
  double min_overlap = 0.6;
  /// Largest difference from the graph, in standard deviations of both. 8 is twice what
  /// chi-square's 99 % allow, because drift is not white noise: 4 refuses the registrations that
  /// correct the drift of fr1/rpy. Lower it where false edges are a worse problem than drift.
  double max_error = 8;
  int points = 1500;                         ///< points of the moving keyframe
  int skip_scales = 1;                       ///< coarsest length scales left out
  double min_cos_theta = 0.4;                ///< least cos_theta, as a share of the usual one
  double max_round_trip_translation = 0.01;  ///< largest difference of the two ways [m]
  double max_round_trip_rotation = 0.015;    ///< largest difference of the two ways [rad]
};

/// Which earlier keyframes a new one is registered to besides its predecessor.
struct ProximityOptions {
  /// Number of keyframes before the predecessor [keyframes]. They hold the drift down; with a
  /// keyframe every quarter of the field of view, the fifth has left the image. 0 switches them
  /// off.
  int recent = 4;
  /// Number of older keyframes that see most of the same [keyframes]. Each costs two registrations.
  /// 0 switches them off.
  int near = 4;
  /// Least overlap by the poses of the graph, in [0, 1], for a registration to be tried. Not below
  /// pair.min_overlap, because what hides the scene is not considered.
  double min_expected_overlap = 0.6;
  int min_gap = 5;        ///< least distance between two of the older keyframes [keyframes]
  PairOptions pair = {};  ///< how these pairs are registered
};

/// When a recognised keyframe is believed where the graph does not say where the camera is:
/// tracking is lost, or the keyframe is of another submap. There may be several places that look
/// the same.
struct RelocalizationOptions {
  /// Number of frames in a row that must agree before a lost camera goes on [frames]; between the
  /// first and the last at least 0.06 s, the time of 3 at 30 Hz. One frame may show an ambiguous
  /// place. Raise it in buildings that repeat.
  int frames = 3;
  /// Number of keyframes that must agree before two submaps are joined [keyframes]. They are a
  /// quarter of a view apart, so that 3 cover some distance. Raise it in buildings that repeat.
  int join_keyframes = 3;
  double min_coverage = 0.6;   ///< least share of image cells that agree, of those both should see
  double min_agreement = 3.2;  ///< least agreement of images and clouds far from the last pose
  double lost_speed = 1.5;     ///< standard deviation of the speed of a lost camera [m/s]
  double lost_angular_speed = 1;  ///< standard deviation of its angular speed [rad/s]
  double rival_share = 0.9;       ///< coverage at which a second place is as good as the first
  double max_disagreement_translation = 0.2;  ///< of keyframes that agree [m]
  double max_disagreement_rotation = 0.1;     ///< of keyframes that agree [rad]
};

/// Whether and how keyframes are recognised by their images.
struct LoopClosingOptions {
  /// True to look for keyframes that show the place of the newest one, wherever the graph has it,
  /// and for lost cameras. Costs about a third of the mapping time. The program's --mode sets it.
  bool enabled = true;
  LoopOptions detection;  ///< how places are recognised by features
  /// How recognised keyframes are registered: at all length scales, and with wider limits than
  /// keyframes that the graph has near each other.
  PairOptions pair = {.min_overlap = 0.5,
                      .skip_scales = 0,
                      .max_round_trip_translation = 0.02,
                      .max_round_trip_rotation = 0.02};
  /// Largest error of a loop in the optimised graph [standard deviations]; a loop with more is
  /// taken back. Lower it where false loops are a worse problem than drift.
  double max_residual = 8;
  RelocalizationOptions relocalization;  ///< when a place is believed that the graph cannot confirm
  bool keep_rejected_matches = false;    ///< keep LoopCandidate::pixels of rejected candidates
};

/// Which keyframes the map does without. What was measured to them is handed on to those that
/// stand in for them, and frames keep their poses relative to these.
struct CullingOptions {
  /// True to remove keyframes for which an older one can stand in: it is nearer than half of the
  /// limits of tracker.keyframe and sees as much of the same as these ask for. A map does not grow
  /// then while the camera stays in places that it has seen. Switch it off to keep every keyframe.
  bool enabled = true;
  /// Most memory that the keyframes may take [MB], whatever `enabled` says; 0 = no limit. Beyond
  /// it, those that are nearest to others are removed, so that the map gets coarser everywhere. 50
  /// keyframes take 6 MB.
  double max_memory = 0;
};

/// All options of Slam.
struct SlamOptions {
  TrackerOptions tracker;  ///< how the camera is tracked
  /// Where the work on the map is done. kPipelined shortens track() where a second core is free;
  /// results do not depend on it.
  Schedule schedule = Schedule::kInline;
  /// Number of keyframes after which the answers of track() contain what the map has learnt from
  /// one [keyframes]. Fixed, so that no result depends on timing. 2 give the map the time between
  /// two keyframes; 0 makes track() wait.
  int correction_delay = 2;
  /// The newest part of the graph is optimised whenever so many keyframes were added [keyframes].
  int optimize_every = 5;
  /// Most points of a keyframe that the map keeps, of those the tracker selects for it. Twice as
  /// many as are registered to them (pair.points): with 6000 the map is no more accurate
  /// (docs/decisions/0028), takes half as much memory again, and a run a seventh more time.
  int map_points = 3000;
  ProximityOptions proximity;  ///< registrations between near keyframes
  LoopClosingOptions loops;    ///< recognition of keyframes by their images
  CullingOptions culling;      ///< which keyframes the map does without
  /// How the graph is optimised. Edges are verified before; kCauchy weakens those that are wrong
  /// all the same.
  OptimizerOptions optimizer = {.loss = RobustLoss::kCauchy};
  /// Standard deviation of what a registration cannot know of its error, such as bent depth and
  /// inexact stamps; added to the covariance of every edge [m], 0 to 1.
  double noise_translation = 0.004;
  double noise_rotation = 0.004;  ///< the same for the rotation [rad], 0 to 1
};

///@{
/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(PairOptions& options);
[[nodiscard]] OptionSet describe(ProximityOptions& options);
[[nodiscard]] OptionSet describe(RelocalizationOptions& options);
[[nodiscard]] OptionSet describe(LoopClosingOptions& options);
[[nodiscard]] OptionSet describe(CullingOptions& options);
[[nodiscard]] OptionSet describe(SlamOptions& options);
///@}

}  // namespace cvo_slam
