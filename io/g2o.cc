// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/g2o.h"

#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

constexpr std::string_view kVertex = "VERTEX_SE3:QUAT";
constexpr std::string_view kEdge = "EDGE_SE3:QUAT";
constexpr std::string_view kFix = "FIX";

/// Takes the words of a line one after the other.
class Words {
 public:
  Words(const std::filesystem::path& file, const TextLine& line) : file_(file), line_(line) {}

  [[nodiscard]] const std::string& tag() const { return line_.words.front(); }
  [[nodiscard]] std::size_t count() const { return line_.words.size() - 1; }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(file_, line_.number, problem);
  }

  void expect(std::size_t values, std::string_view what) const {
    if (count() == values) return;
    fail(fmt::format("{} has {} values, expected {}: {}", tag(), count(), values, what));
  }

  NodeId id() {
    const std::string& word = next();
    const auto value = parse_integer<NodeId>(word);
    if (!value) fail(fmt::format("'{}' is not the number of a vertex", word));
    return *value;
  }

  double number() {
    const std::string& word = next();
    const auto value = parse_finite(word);
    if (!value) {
      fail(fmt::format("'{}' is not a finite number; repair or remove the line", word));
    }
    return *value;
  }

  SE3 pose() {
    Vector3 p;
    for (double& value : p) value = number();
    Eigen::Vector4d q;
    for (double& value : q) value = number();
    if (q.squaredNorm() < 1e-12) {
      fail("the quaternion has length zero; repair or remove the line");
    }
    return SE3::from_quaternion(q[0], q[1], q[2], q[3], p);
  }

  Matrix6 symmetric_matrix() {
    Matrix6 matrix;
    for (int row = 0; row < 6; ++row) {
      for (int column = row; column < 6; ++column) matrix(row, column) = number();
    }
    return matrix.selfadjointView<Eigen::Upper>();
  }

 private:
  const std::string& next() { return line_.words[next_++]; }

  const std::filesystem::path& file_;
  const TextLine& line_;
  std::size_t next_ = 1;
};

PoseGraphNode parse_vertex(Words& words) {
  words.expect(8, "id x y z qx qy qz qw");
  const NodeId id = words.id();
  return {id, words.pose()};
}

PoseGraphEdge parse_edge(Words& words) {
  words.expect(30, "from to x y z qx qy qz qw and 21 of the information matrix");
  PoseGraphEdge edge;
  edge.from = words.id();
  edge.to = words.id();
  edge.T_from_to = words.pose();
  edge.information = words.symmetric_matrix();
  return edge;
}

bool joins_successive_nodes(const PoseGraphEdge& edge, const std::set<NodeId>& ids) {
  const auto next = ids.upper_bound(edge.from);
  return next != ids.end() && *next == edge.to;
}

/// Returns the same graph with the edges that do not join a node to the next one marked as loops.
PoseGraph with_kinds(const PoseGraph& graph) {
  std::set<NodeId> ids;
  PoseGraph result;
  for (const PoseGraphNode& node : graph.nodes()) {
    ids.insert(node.id);
    result.add_node(node);
  }
  for (PoseGraphEdge edge : graph.edges()) {
    edge.robust = !joins_successive_nodes(edge, ids);
    edge.kind = edge.robust ? EdgeKind::kLoop : EdgeKind::kOdometry;
    result.add_edge(edge);
  }
  return result;
}

void fix(PoseGraph& graph, Words& words) {
  if (words.count() == 0) words.fail("FIX names no vertex; remove the line");
  for (std::size_t i = 0; i < words.count(); ++i) graph.set_fixed(graph.index_of(words.id()), true);
}

[[noreturn]] void fail_unknown(const Words& words) {
  const std::string_view tag = words.tag();
  if (tag.find("SE2") != std::string_view::npos || tag == "VERTEX2" || tag == "EDGE2") {
    words.fail(fmt::format("{}: a planar graph; only 3D graphs are read, make it {} and {}", tag,
                           kVertex, kEdge));
  }
  words.fail(fmt::format("unknown entry '{}'; {}, {} and {} are read", tag, kVertex, kEdge, kFix));
}

/// Adds the entry of a line if it has this tag. Edges may stand above their vertices: a reader adds
/// one kind of entry after the other.
void add_entries(PoseGraph& graph, std::string_view tag, Words words) {
  if (words.tag() != tag) return;
  try {
    if (tag == kVertex) graph.add_node(parse_vertex(words));
    if (tag == kEdge) graph.add_edge(parse_edge(words));
    if (tag == kFix) fix(graph, words);
  } catch (const DataError& error) {
    words.fail(error.what());
  }
}

Eigen::Vector4d rounded_quaternion(const SE3& pose) {
  constexpr double kGrid = 1e14;
  Eigen::Vector4d q = pose.quaternion();
  for (double& value : q) value = std::round(kGrid * value) / kGrid + 0.0;  // no -0
  return q;
}

/// Returns a quaternion whose digits are the same after it was read, converted to a rotation matrix
/// and written again. It is rounded to a grid that is coarser than the rounding errors of that
/// conversion; each repetition brings its length nearer to 1, until nothing changes.
Eigen::Vector4d repeatable_quaternion(const SE3& pose) {
  Eigen::Vector4d q = rounded_quaternion(pose);
  constexpr int kMostRepetitions = 100;  // two or three are usual
  for (int i = 0; i < kMostRepetitions; ++i) {
    const SE3 read = SE3::from_quaternion(q[0], q[1], q[2], q[3], Vector3::Zero());
    const Eigen::Vector4d next = rounded_quaternion(read);
    if (next == q) break;
    q = next;
  }
  return q;
}

std::string format_pose(const SE3& pose) {
  const Vector3& p = pose.translation();
  const Eigen::Vector4d q = repeatable_quaternion(pose);
  return fmt::format("{} {} {} {} {} {} {}", p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
}

std::string format_edge(const PoseGraphEdge& edge) {
  std::string text =
      fmt::format("{} {} {} {}", kEdge, edge.from, edge.to, format_pose(edge.T_from_to));
  for (int row = 0; row < 6; ++row) {
    for (int column = row; column < 6; ++column) {
      text += fmt::format(" {}", edge.information(row, column));
    }
  }
  return text + "\n";
}

}  // namespace

PoseGraph read_g2o(const std::filesystem::path& file) {
  const std::vector<TextLine> lines = read_word_lines(file);
  for (const TextLine& line : lines) {
    const Words words(file, line);
    if (words.tag() != kVertex && words.tag() != kEdge && words.tag() != kFix) fail_unknown(words);
  }
  PoseGraph graph;
  for (const std::string_view tag : {kVertex, kEdge, kFix}) {
    for (const TextLine& line : lines) add_entries(graph, tag, Words(file, line));
  }
  if (graph.nodes().empty()) {
    throw InputError(file, fmt::format("no {} in it; is it a pose graph?", kVertex));
  }
  return with_kinds(graph);
}

void write_g2o(const std::filesystem::path& file, const PoseGraph& graph) {
  std::string text;
  for (const PoseGraphNode& node : graph.nodes()) {
    text += fmt::format("{} {} {}\n", kVertex, node.id, format_pose(node.T_world_node));
  }
  for (const PoseGraphNode& node : graph.nodes()) {
    if (node.fixed) text += fmt::format("{} {}\n", kFix, node.id);
  }
  for (const PoseGraphEdge& edge : graph.edges()) text += format_edge(edge);
  write_file(file, text);
}

}  // namespace cvo_slam
