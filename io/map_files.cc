// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/map_files.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/g2o.h"
#include "cvo_slam/io/map_header_internal.h"
#include "cvo_slam/io/map_memory_files_internal.h"
#include "cvo_slam/io/ply.h"
#include "cvo_slam/io/surface_file_internal.h"
#include "cvo_slam/io/text_internal.h"
#include "cvo_slam/io/trajectory_files.h"

namespace cvo_slam {
namespace {

constexpr std::string_view kKeyframes = "keyframes.txt";
constexpr std::string_view kPoints = "map.ply";

constexpr std::array<std::pair<std::string_view, EdgeKind>, 3> kKinds = {
    {{"odometry", EdgeKind::kOdometry},
     {"proximity", EdgeKind::kProximity},
     {"loop", EdgeKind::kLoop}}};

std::string_view name_of(EdgeKind kind) {
  return std::find_if(kKinds.begin(), kKinds.end(),
                      [&](const auto& entry) { return entry.second == kind; })
      ->first;
}

std::string edges_text(const PoseGraph& graph) {
  std::string text = "# from to kind, in the order of graph.g2o\n";
  for (const PoseGraphEdge& edge : graph.edges()) {
    text += fmt::format("{} {} {}\n", edge.from, edge.to, name_of(edge.kind));
  }
  return text;
}

EdgeKind parse_kind(const std::filesystem::path& file, const TextLine& line,
                    const PoseGraphEdge& edge) {
  const auto& words = line.words;
  if (words.size() != 3 || words[0] != std::to_string(edge.from) ||
      words[1] != std::to_string(edge.to)) {
    throw InputError(
        file, line.number,
        fmt::format("expected '{} {} <kind>' as in {}; both files must belong to the same map",
                    edge.from, edge.to, kGraphFile));
  }
  const auto* kind = std::find_if(kKinds.begin(), kKinds.end(),
                                  [&](const auto& entry) { return entry.first == words[2]; });
  if (kind == kKinds.end()) {
    throw InputError(
        file, line.number,
        fmt::format("'{}' is no kind of edge; there are odometry, proximity and loop", words[2]));
  }
  return kind->second;
}

/// Returns the graph with the kinds of edges that the file gives.
PoseGraph with_edge_kinds(const PoseGraph& graph, const std::filesystem::path& file) {
  const std::vector<TextLine> lines = read_word_lines(file);
  if (lines.size() != graph.edges().size()) {
    throw InputError(file,
                     fmt::format("{} edges, but {} in {}; both files must belong to the same map",
                                 lines.size(), graph.edges().size(), kGraphFile));
  }
  PoseGraph result;
  for (const PoseGraphNode& node : graph.nodes()) result.add_node(node);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    PoseGraphEdge edge = graph.edges()[i];
    edge.kind = parse_kind(file, lines[i], edge);
    edge.robust = edge.kind != EdgeKind::kOdometry;
    result.add_edge(edge);
  }
  return result;
}

void check_sizes(const std::filesystem::path& folder, const Map& map) {
  const std::size_t nodes = map.graph.nodes().size();
  if (nodes == 0 || nodes == map.keyframes.size()) return;
  throw InputError(folder, fmt::format("{} keyframes in {}, but {} nodes in {}; both files must "
                                       "belong to the same map",
                                       map.keyframes.size(), kKeyframes, nodes, kGraphFile));
}

void read_points(const std::filesystem::path& file, Map& map, std::vector<std::string>& notes) {
  PlyCloud cloud = read_ply(file);
  map.points = std::move(cloud.points);
  map.points_origin = cloud.origin;
  notes.insert(notes.end(), cloud.notes.begin(), cloud.notes.end());
}

/// Reads the memory; the keyframes' stamps are there and their poses in the graph.
void add_memory(const std::filesystem::path& folder, const MapHeader& header, Map& map) {
  map.memory = read_memory(folder, header);
  if (header.has(kSurfaceFile)) {
    CheckedFile surface = header.open_checked(folder, kSurfaceFile);
    read_surface(surface, map);
  }
  const auto& keyframes = map.memory->keyframes;
  if (keyframes.size() != map.graph.nodes().size()) {
    throw InputError(folder, fmt::format("{} keyframes, but {} nodes in {}; make the map again",
                                         keyframes.size(), map.graph.nodes().size(), kGraphFile));
  }
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    map.keyframes.push_back({keyframes[i].stamp, map.graph.nodes()[i].T_world_node});
  }
}

Map read_files(const std::filesystem::path& folder, std::vector<std::string>& notes,
               ForeignEntries foreign) {
  const auto has = [&](std::string_view name) { return std::filesystem::exists(folder / name); };
  if (!std::filesystem::is_directory(folder)) {
    throw InputError(folder, "is not a folder; give a folder that cvo_slam run has written");
  }
  std::optional<MapHeader> header;
  if (has(kMapHeader)) header.emplace(folder);
  if (!has(kKeyframes) && !has(kGraphFile) && !has(kPoints) && !header) {
    throw InputError(folder, fmt::format("holds no map: none of {}, {} and {}; give a folder that "
                                         "cvo_slam run has written",
                                         kKeyframes, kGraphFile, kPoints));
  }
  if (header) header->check_small_files(folder);
  Map map;
  if (has(kKeyframes)) map.keyframes = read_tum(folder / kKeyframes);
  // A session may be saved before the map has a keyframe.
  const bool has_nodes =
      has(kGraphFile) && !(header && std::filesystem::is_empty(folder / kGraphFile));
  if (has_nodes) map.graph = read_g2o(folder / kGraphFile, notes, foreign);
  if (has(kGraphFile) && has(kEdgesFile))
    map.graph = with_edge_kinds(map.graph, folder / kEdgesFile);
  if (has(kPoints)) read_points(folder / kPoints, map, notes);
  if (has(kKeyframes)) check_sizes(folder, map);
  if (header) add_memory(folder, *header, map);
  return map;
}

void write_files(const std::filesystem::path& folder, const Map& map) {
  if (!map.graph.nodes().empty() || map.memory) {
    write_g2o(folder / kGraphFile, map.graph);
    write_file(folder / kEdgesFile, edges_text(map.graph));
  }
  if (map.points.empty()) return;
  if (map.memory) {
    write_surface(folder / kSurfaceFile, map);
  } else {
    write_ply(folder / kPoints, map.points, map.points_origin);
  }
}

}  // namespace

void write_map(const std::filesystem::path& folder, const Map& map) {
  const bool has_graph = !map.graph.nodes().empty();
  if (has_graph && !map.keyframes.empty() && map.graph.nodes().size() != map.keyframes.size()) {
    throw DataError(
        fmt::format("the map has {} keyframes, but its graph has {} nodes; each keyframe "
                    "must have one node",
                    map.keyframes.size(), map.graph.nodes().size()));
  }
  if (!map.memory) {
    make_folder(folder);
    if (!map.keyframes.empty() || !has_graph) {
      write_tum(folder / kKeyframes, {map.keyframes, {}});
    }
    return write_files(folder, map);
  }
  replace_folder(folder, [&map](const std::filesystem::path& place) {
    write_files(place, map);
    write_memory(place, *map.memory);
    write_map_header(place, *map.memory);
  });
}

bool is_map_folder(const std::filesystem::path& folder) {
  return std::filesystem::is_regular_file(folder / kMapHeader);
}

Map read_map(const std::filesystem::path& folder, std::vector<std::string>& notes) {
  return read_files(folder, notes, ForeignEntries::kSkip);
}

Map read_map(const std::filesystem::path& folder) {
  std::vector<std::string> notes;
  return read_files(folder, notes, ForeignEntries::kRefuse);
}

}  // namespace cvo_slam
