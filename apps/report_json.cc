// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/report_json.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/apps/benchmark_report.h"
#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/apps/frame_pair.h"
#include "cvo_slam/apps/frame_registration.h"
#include "cvo_slam/apps/graph_report.h"
#include "cvo_slam/apps/odometry_benchmark.h"
#include "cvo_slam/apps/run_report.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {
namespace {

using Json = nlohmann::ordered_json;

// The errors of a trajectory.

Json json_of(const Statistics& s) {
  return {{"rmse", s.rmse}, {"mean", s.mean}, {"median", s.median}, {"std", s.std},
          {"min", s.min},   {"max", s.max},   {"sse", s.sse}};
}

Json json_of(const PoseErrorStatistics& statistics) {
  return {{"count", statistics.translation.count},
          {"translation_m", json_of(statistics.translation)},
          {"rotation_deg", json_of(in_unit(statistics.rotation, kDegrees))}};
}

Json json_of(const RelativeEvaluation& relative) {
  const auto& options = relative.options;
  const bool paper = options.kind == RelativeErrorKind::kCvoPaper;
  return {{"delta", options.delta},
          {"unit", to_string(options.unit)},
          {"all_pairs", options.all_pairs},
          {"definition", paper ? "cvo_paper" : "relative_pose"},
          {"error", relative.error ? json_of(relative.error->statistics) : nullptr}};
}

Json json_of(const LeftOutLines& left_out) {
  return {{"repeated_stamp", left_out.repeated}, {"invalid", left_out.invalid}};
}

Json json_of(const EvaluationReport& report) {
  const auto& association = report.options.association;
  Json json = {{"reference_poses", report.reference_poses},
               {"estimate_poses", report.estimate_poses},
               {"matches", report.matches},
               {"unmatched", report.unmatched},
               {"left_out",
                {{"reference", json_of(report.left_out.reference)},
                 {"estimate", json_of(report.left_out.estimate)}}},
               {"coverage", report.coverage},
               {"interpolate", association.interpolate},
               {"max_difference_s", association.max_difference},
               {"time_offset_s", association.time_offset},
               {"alignment", name_of(report.options.alignment)}};
  json["scale"] = report.ate ? Json(report.ate->alignment.scale) : nullptr;
  json["ate"] = report.ate ? json_of(report.ate->statistics) : nullptr;
  json["rpe"] = Json::array();
  for (const auto& relative : report.relative) json["rpe"].push_back(json_of(relative));
  json["notes"] = report.notes;
  json["warnings"] = report.warnings;
  if (report.at_best_offset) json["at_best_time_offset"] = json_of(*report.at_best_offset);
  return json;
}

// The comparison with other systems.

constexpr double kMillisecondsInASecond = 1e3;

Json milliseconds(const Statistics& seconds) {
  return {{"median", seconds.median * kMillisecondsInASecond},
          {"mean", seconds.mean * kMillisecondsInASecond}};
}

Json json_of(const PoseError& error) {
  return {{"stamp", error.stamp.to_string()},
          {"translation_m", error.translation},
          {"rotation_deg", error.rotation * kDegrees}};
}

Json json_of(const ContestantResult& result) {
  Json json = {
      {"name", result.name}, {"description", result.description}, {"built_in", result.built_in}};
  if (!result.built_in) return json;
  json["lost"] = result.lost;
  json["features_asked"] = nullptr;
  if (result.features_asked) json["features_asked"] = *result.features_asked;
  json["wrong"] = nullptr;
  if (result.wrong) {
    json["wrong"] = {{"checked", result.wrong->checked}, {"frames", Json::array()}};
    for (const PoseError& error : result.wrong->frames) {
      json["wrong"]["frames"].push_back(json_of(error));
    }
  }
  json["cpu_ms"] = milliseconds(result.cpu);
  json["finish_cpu_ms"] = result.finish_cpu * kMillisecondsInASecond;
  json["evaluation"] = nullptr;
  if (result.evaluation) json["evaluation"] = json_of(*result.evaluation);
  return json;
}

/// The length of the reference trajectory during these frames [m].
double reference_path(const Dataset& data, const FrameRange& frames) {
  if (frames.begin >= frames.end) return 0;
  std::vector<StampedPose> poses;
  for (const StampedPose& pose : data.reference()) {
    if (pose.stamp >= data.stamp(frames.begin) && pose.stamp <= data.stamp(frames.end - 1)) {
      poses.push_back(pose);
    }
  }
  return path_length(poses);
}

Json json_of(const Dataset& data, const OdometryBenchmark& benchmark) {
  Json json = {{"sequence", data.name()},
               {"kind", data.kind()},
               {"camera", data.camera().name},
               {"begin", benchmark.frames.begin},
               {"end", benchmark.frames.end},
               {"step", benchmark.frames.step},
               {"depth_offset", benchmark.depth_offset},
               {"reference_path_m", reference_path(data, benchmark.frames)},
               {"protocol", benchmark_protocol()},
               {"decoding_cpu_ms", milliseconds(benchmark.decoding)}};
  json["systems"] = Json::array();
  for (const auto& result : benchmark.results) json["systems"].push_back(json_of(result));
  return json;
}

// The registration of two frames.

std::array<double, 3> array(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json pose_json(const SE3& T) {
  const Eigen::Vector4d q = T.quaternion();
  return {{"translation_m", array(T.translation())},
          {"quaternion_xyzw", {q.x(), q.y(), q.z(), q.w()}}};
}

Json similarity_json(const CloudSimilarity& similarity) {
  return {{"inner_product", similarity.inner_product},
          {"cos_theta", similarity.cos_theta},
          {"overlap", similarity.overlap},
          {"kernel_entries", similarity.entries}};
}

Json information_json(const Matrix6& information) {
  auto rows = Json::array();
  for (int row = 0; row < 6; ++row) {
    auto values = Json::array();
    for (int column = 0; column < 6; ++column) values.push_back(information(row, column));
    rows.push_back(values);
  }
  return rows;
}

std::string_view word_of(RegistrationStatus status) {
  return status == RegistrationStatus::kConverged ? "converged" : "iteration_limit";
}

Json json_of(const FramePair& pair, const FrameRegistration& registration) {
  const RegistrationResult& result = registration.result;
  const Vector6 deviations = standard_deviations(result);
  Json json = {{"a", pair.name_a}, {"b", pair.name_b}};
  if (!pair.source.empty()) json["sequence"] = pair.source;
  if (pair.seconds) json["interval_s"] = *pair.seconds;
  json["T_a_b"] = pose_json(result.T_fixed_moving);
  json["standard_deviation"] = {{"translation_m", array(deviations.head<3>())},
                                {"rotation_rad", array(deviations.tail<3>())}};
  json["information"] = information_json(inverse_of_spd(result.covariance));
  json["error"] = nullptr;
  if (pair.T_a_b_truth) {
    const SE3 error = pair.T_a_b_truth->inverse() * result.T_fixed_moving;
    json["error"] = {{"translation_m", error.translation().norm()},
                     {"rotation_deg", error.angle() * kDegrees}};
  }
  json["status"] = word_of(result.status);
  json["rejection"] = registration.rejection;
  json["iterations"] = result.iterations;
  json["points_a"] = registration.points_a.size();
  json["points_b"] = registration.points_b.size();
  json["length_scale_m"] = registration.length_scale;
  json["before"] = similarity_json(registration.before);
  json["after"] = similarity_json(registration.after);
  json["cpu_ms"] = registration.cpu_seconds * 1000;
  return json;
}

// A run.

auto candidates_of_kind(const std::vector<LoopCandidate>& candidates, EdgeKind kind) {
  return std::count_if(candidates.begin(), candidates.end(),
                       [&](const LoopCandidate& candidate) { return candidate.kind == kind; });
}

Json json_of(const GraphResult& result) {
  const GraphStatistics& statistics = result.statistics;
  const Summary& last = statistics.last_full;
  return {{"nodes", result.graph.nodes().size()},
          {"odometry_edges", edges_of_kind(result.graph, EdgeKind::kOdometry)},
          {"proximity_edges", edges_of_kind(result.graph, EdgeKind::kProximity)},
          {"loop_edges", edges_of_kind(result.graph, EdgeKind::kLoop)},
          {"candidates", result.candidates.size()},
          {"bow_candidates", candidates_of_kind(result.candidates, EdgeKind::kLoop)},
          {"window_solves", statistics.window_solves},
          {"window_s", statistics.window_seconds},
          {"full_solves", statistics.full_solves},
          {"full_s", statistics.full_seconds},
          {"keyframes_mb", static_cast<double>(statistics.keyframe_bytes) / kBytesOfMegabyte},
          {"redundant_keyframes", statistics.redundant_keyframes},
          {"dropped_keyframes", statistics.dropped_keyframes},
          {"last_full",
           {{"initial_cost", last.initial_cost},
            {"final_cost", last.final_cost},
            {"iterations", last.iterations},
            {"converged", last.converged},
            {"rejected_edges", last.rejected_edges()}}}};
}

Json json_of(const RunMap& run_map) {
  return {{"keyframes", run_map.map.keyframes.size()},
          {"points", run_map.map.points.size()},
          {"cpu_s", run_map.cpu_seconds},
          {"renderer", run_map.renderer}};
}

/// Returns the text of an option as a number, a truth value or a list if it is one.
Json json_of(const std::string& text) {
  auto json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Json(text) : json;
}

Json options_json(ProgramOptions options) {
  Json json;
  for (const auto& option : describe(options).options()) json[option.key] = json_of(option.get());
  return json;
}

Json json_of(const DepthClock& clock) {
  const bool measured = clock.measurement && clock.measurement->is_measured;
  return {{"seconds", clock.seconds},
          {"measured", measured},
          {"uncertainty_s", measured ? Json(clock.measurement->uncertainty) : Json()},
          {"origin", clock.origin}};
}

Json json_of(const RunReport& report) {
  const OdometryRun& run = report.run;
  Json json = {{"sequence", report.data.name()},
               {"kind", report.data.kind()},
               {"camera", report.data.camera().name},
               {"camera_origin", report.data.camera_origin()},
               {"depth_offset", json_of(report.clock)},
               {"mode", report.mode},
               {"version", CVO_SLAM_VERSION},
               {"interrupted", run.signal != 0},
               {"frames",
                {{"first", report.range.begin},
                 {"end", report.range.end},
                 {"step", report.range.step},
                 {"processed", run.records.size()},
                 {"tracked", report.trajectory.poses.size()},
                 {"lost", report.trajectory.lost.size()},
                 {"keyframes", run.keyframes()}}},
               {"unpaired",
                {{"color", report.data.unpaired().color}, {"depth", report.data.unpaired().depth}}},
               {"path_m", path_length(report.trajectory.poses)},
               {"cost",
                {{"fps", run.fps()},
                 {"wall_s", run.seconds},
                 {"cpu_s", run.cpu_seconds},
                 {"read_ms_median", median_cost(run, &FrameCost::read_ms)},
                 {"track_ms_median", median_cost(run, &FrameCost::track_ms)},
                 {"peak_memory_mb", run.peak_memory_mb}}}};
  json["localized_frames"] = nullptr;
  if (report.map_use) json["localized_frames"] = report.localized_frames();
  json["first_lost"] = nullptr;
  if (!report.trajectory.lost.empty()) {
    const LostFrame& lost = report.trajectory.lost.front();
    json["first_lost"] = {{"stamp", lost.stamp.to_string()}, {"reason", lost.reason}};
  }
  if (report.graph) json["graph"] = json_of(*report.graph);
  json["map"] = json_of(report.map);
  json["evaluation"] = report.evaluation ? json_of(*report.evaluation) : nullptr;
  json["notes"] = report.notes;
  json["options"] = options_json(report.options);
  return json;
}

}  // namespace

namespace {

/// Names of files need not be UTF-8, which JSON must be.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string json_text(const EvaluationReport& report) { return text_of(json_of(report)); }

std::string json_text(const Dataset& data, const OdometryBenchmark& benchmark) {
  return text_of(json_of(data, benchmark));
}

std::string json_text(const FramePair& pair, const FrameRegistration& registration) {
  return text_of(json_of(pair, registration));
}

std::string json_text(const RunReport& report) { return text_of(json_of(report)); }

}  // namespace cvo_slam
