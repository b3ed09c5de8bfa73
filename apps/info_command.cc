// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/apps/depth_clock.h"
#include "cvo_slam/apps/graph_report.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/io/camera_check.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/io/map_files.h"

namespace cvo_slam {
namespace {

struct InfoArguments {
  DatasetArguments sequence;
  bool check = false;
  bool json = false;
};

/// Figures of a data set that `info` prints.
struct DatasetInfo {
  double duration = 0;         ///< from the first to the last frame [s]
  double rate = 0;             ///< [Hz]
  std::size_t referenced = 0;  ///< frames within the time span of the reference
};

DatasetInfo measure(const Dataset& data) {
  DatasetInfo info;
  const auto& reference = data.reference();
  info.duration = seconds_between(data.stamp(0), data.stamp(data.size() - 1));
  if (info.duration > 0) info.rate = static_cast<double>(data.size() - 1) / info.duration;
  for (std::size_t i = 0; i < data.size() && !reference.empty(); ++i) {
    const Timestamp stamp = data.stamp(i);
    if (stamp >= reference.front().stamp && stamp <= reference.back().stamp) ++info.referenced;
  }
  return info;
}

nlohmann::json camera_json(const PinholeCamera& camera) {
  return {{"width", camera.width},
          {"height", camera.height},
          {"fx", camera.fx},
          {"fy", camera.fy},
          {"cx", camera.cx},
          {"cy", camera.cy},
          {"distortion", camera.distortion}};
}

nlohmann::json camera_json(const Camera& camera) {
  nlohmann::json json = camera_json(camera.color);
  json["name"] = camera.name;
  json["depth_scale"] = camera.depth_scale;
  json["depth"] = camera.depth ? camera_json(camera.depth->pinhole) : nlohmann::json();
  return json;
}

void print_json(const Dataset& data, const DepthClock& clock,
                const std::optional<Reprojection>& agreement,
                const std::vector<std::string>& notes) {
  const DatasetInfo info = measure(data);
  nlohmann::json json = {
      {"name", data.name()},
      {"kind", data.kind()},
      {"camera", camera_json(data.camera())},
      {"camera_origin", data.camera_origin()},
      {"depth_offset_s", clock.seconds},
      {"depth_offset_origin", clock.origin},
      {"frames", data.size()},
      {"duration_s", info.duration},
      {"rate_hz", info.rate},
      {"unpaired", {{"color", data.unpaired().color}, {"depth", data.unpaired().depth}}},
      {"reference",
       {{"poses", data.reference().size()},
        {"path_m", path_length(data.reference())},
        {"frames_covered", info.referenced}}},
      {"reprojection", nullptr},
      {"notes", notes}};
  if (agreement) {
    json["reprojection"] = {{"pairs", agreement->pairs},
                            {"mean_squared_grey_difference", agreement->color_error},
                            {"mean_squared_grey_difference_unmoved", agreement->still_error},
                            {"relative_depth_error", agreement->depth_error}};
  }
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string describe(const PinholeCamera& camera) {
  return fmt::format("{}x{}, fx {} fy {} cx {} cy {}{}", camera.width, camera.height, camera.fx,
                     camera.fy, camera.cx, camera.cy,
                     camera.has_distortion() ? ", with distortion" : "");
}

void print_camera(const Camera& camera) {
  fmt::print("camera     {}: {}\n", camera.name, describe(camera.color));
  fmt::print("depth      {} units a metre, ", camera.depth_scale);
  if (camera.depth) {
    fmt::print("registered to colour while reading: {}\n", describe(camera.depth->pinhole));
  } else {
    fmt::print("registered to colour in the files\n");
  }
}

void print_text(const Dataset& data, const DepthClock& clock,
                const std::optional<Reprojection>& agreement,
                const std::vector<std::string>& notes) {
  const DatasetInfo info = measure(data);
  fmt::print("name       {}\nkind       {}\n", data.name(), data.kind());
  print_camera(data.camera());
  fmt::print("origin     {}\nclock      depth offset {}\n", data.camera_origin(), clock.text());
  fmt::print("frames     {} in {:.2f} s, {:.1f} Hz\n", data.size(), info.duration, info.rate);
  fmt::print("unpaired   {} colour, {} depth images\n", data.unpaired().color,
             data.unpaired().depth);
  if (data.reference().empty()) {
    fmt::print("reference  none\n");
  } else {
    fmt::print("reference  {} poses, {:.2f} m, covers {} of {} frames\n", data.reference().size(),
               path_length(data.reference()), info.referenced, data.size());
  }
  if (agreement) {
    fmt::print(
        "check      {} pairs of frames: depth agrees to {:.1f} %, grey values differ by {:.1f} "
        "(unmoved {:.1f})\n",
        agreement->pairs, 100 * agreement->depth_error, std::sqrt(agreement->color_error),
        std::sqrt(agreement->still_error));
  }
  for (const auto& note : notes) fmt::print("note       {}\n", note);
}

/// Describes a map that `run --save-map` wrote.
int run_map_info(const InfoArguments& arguments) {
  const std::filesystem::path& folder = arguments.sequence.dataset;
  std::vector<std::string> notes;
  const Map map = read_map(folder, notes);
  const MapMemory& memory = *map.memory;
  std::uintmax_t bytes = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) bytes += file.file_size();
  std::size_t with_features = 0;
  for (const KeyframeMemory& keyframe : memory.keyframes) {
    with_features += keyframe.features.empty() ? 0 : 1;
  }
  const auto component_of = map.graph.components();
  const std::size_t components =
      std::set<std::size_t>(component_of.begin(), component_of.end()).size();
  const nlohmann::json json = {{"kind", "map"},
                               {"camera", camera_json(memory.camera)},
                               {"keyframes", memory.keyframes.size()},
                               {"keyframes_with_features", with_features},
                               {"submaps", components},
                               {"odometry_edges", edges_of_kind(map.graph, EdgeKind::kOdometry)},
                               {"proximity_edges", edges_of_kind(map.graph, EdgeKind::kProximity)},
                               {"loop_edges", edges_of_kind(map.graph, EdgeKind::kLoop)},
                               {"points", map.points.size()},
                               {"bytes", bytes},
                               {"notes", notes}};
  if (arguments.json) {
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return kDone;
  }
  fmt::print("kind       map of cvo_slam, to go on from it (run --load-map)\n");
  print_camera(memory.camera);
  fmt::print("keyframes  {}, {} of them with features; in {} submap{}\n", memory.keyframes.size(),
             with_features, components, components == 1 ? "" : "s that no edge joins");
  fmt::print("graph      {} odometry edges, {} proximity edges, {} loop edges\n",
             edges_of_kind(map.graph, EdgeKind::kOdometry),
             edges_of_kind(map.graph, EdgeKind::kProximity),
             edges_of_kind(map.graph, EdgeKind::kLoop));
  fmt::print("points     {}\nsize       {:.1f} MB\n", map.points.size(),
             1e-6 * static_cast<double>(bytes));
  for (const auto& note : notes) fmt::print("note       {}\n", note);
  return kDone;
}

int run_info(const InfoArguments& arguments) {
  if (is_map_folder(arguments.sequence.dataset)) return run_map_info(arguments);
  const TimedSequence timed = arguments.check ? open_timed(arguments.sequence, TrackerOptions())
                                              : open_untimed(arguments.sequence);
  const auto& data = timed.data;
  std::vector<std::string> notes = data->notes();
  if (const std::string problem = data->read(0).problem; !problem.empty()) {
    notes.push_back("warning: the first frame cannot be used: " + problem);
  }
  std::optional<Reprojection> agreement;
  if (arguments.check) {
    agreement = measure_reprojection(*data, data->reference());
    if (!agreement) notes.emplace_back("no check of the camera: it needs ground truth and motion");
  }
  if (agreement) {
    const auto warning = reprojection_warning(*agreement, "the ground truth");
    if (warning) notes.push_back("warning: " + *warning);
  }
  if (arguments.json) {
    print_json(*data, timed.clock, agreement, notes);
  } else {
    print_text(*data, timed.clock, agreement, notes);
  }
  return kDone;
}

}  // namespace

void add_info_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<InfoArguments>();
  Command command(app, "info", "Describe a data set, or a map that run --save-map wrote");
  arguments->sequence.add_to(command);
  command.add(
      "--check", &arguments->check,
      "Also measure the depth offset, and re-project a few frames into each other by the ground "
      "truth: says whether the camera fits the images");
  command.add("--json", &arguments->json, "Print one JSON object instead of text");
  command.on_parsed(action, [arguments] { return run_info(*arguments); });
}

}  // namespace cvo_slam
