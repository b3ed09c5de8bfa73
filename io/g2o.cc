// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/g2o.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/numbers.h"
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
  [[nodiscard]] long line() const { return line_.number; }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(file_, line_.number, problem);
  }

  void expect(std::size_t values, std::string_view what) const {
    if (count() == values) return;
    fail(fmt::format("{} has {} values, expected {}: {}; repair or remove the line", tag(), count(),
                     values, what));
  }

  NodeId id() {
    const std::string& word = next();
    const auto value = parse_integer<NodeId>(word);
    if (!value) {
      fail(fmt::format("'{}' is not the number of a vertex; write a whole number", word));
    }
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

/// Returns true for an edge between neighbours in the order of ids: programs measure the motion
/// from the older to the newer node, or from the newer to the older one.
bool joins_successive_nodes(const PoseGraphEdge& edge, const std::set<NodeId>& ids) {
  const auto [older, newer] = std::minmax(edge.from, edge.to);
  const auto next = ids.upper_bound(older);
  return next != ids.end() && *next == newer;
}

/// Returns the same graph with the edges that do not join successive nodes marked as loops.
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

/// Raises eigenvalues of an information matrix that are negative by rounding to 0. Returns false if
/// there is none; matrices that are really indefinite stay as they are.
bool repair_rounding(Matrix6& information) {
  if (Eigen::LLT<AlignedMatrix6>(information).info() == Eigen::Success) return false;
  const Eigen::SelfAdjointEigenSolver<AlignedMatrix6> eigen(information);
  const double largest = eigen.eigenvalues().maxCoeff();
  const double smallest = eigen.eigenvalues().minCoeff();
  // Files have six digits or more: 21 values that are each off by 5e-7 of themselves.
  constexpr double kRounding = 5e-6;
  constexpr double kExact = 1e-14;  // of the eigenvalues: a matrix of low rank is no fault
  if (!(smallest > -kRounding * largest) || smallest >= -kExact * largest) return false;
  const AlignedMatrix6 raised = eigen.eigenvectors() *
                                eigen.eigenvalues().cwiseMax(0).asDiagonal() *
                                eigen.eigenvectors().transpose();
  information = (raised + raised.transpose()) / 2;
  return true;
}

/// Returns what a foreign entry is, as a plural; empty for an entry that is not known.
std::string_view foreign_kind(std::string_view tag) {
  const auto contains = [&](std::initializer_list<std::string_view> parts) {
    return std::any_of(parts.begin(), parts.end(), [&](std::string_view part) {
      return tag.find(part) != std::string_view::npos;
    });
  };
  if (tag.starts_with("PARAMS_")) return "parameters";
  if (!tag.starts_with("VERTEX_") && !tag.starts_with("EDGE_")) return {};
  if (contains({"PRIOR"})) return "priors";
  return contains({"XYZ", "TRACK", "PROJECT", "PLANE"}) ? "landmarks" : std::string_view();
}

bool is_planar(std::string_view tag) {
  constexpr std::array<std::string_view, 4> kPlanar = {"VERTEX2", "EDGE2", "VERTEX_XY", "EDGE_XY"};
  const bool is_entry = tag.starts_with("VERTEX") || tag.starts_with("EDGE");
  return (is_entry && tag.find("SE2") != std::string_view::npos) ||
         std::find(kPlanar.begin(), kPlanar.end(), tag) != kPlanar.end();
}

[[noreturn]] void fail_unknown(const Words& words) {
  const std::string_view tag = words.tag();
  if (is_planar(tag)) {
    words.fail(fmt::format("{}: a planar graph; only 3D graphs are read, make it {} and {}", tag,
                           kVertex, kEdge));
  }
  words.fail(fmt::format("unknown entry '{}'; {}, {} and {} are read: remove the line", tag,
                         kVertex, kEdge, kFix));
}

/// Makes a graph of the lines of a file and notes what it leaves out or changes.
class GraphReader {
 public:
  GraphReader(const std::filesystem::path& file, ForeignEntries foreign)
      : file_(file), foreign_(foreign) {}

  PoseGraph read() {
    const std::vector<TextLine> lines = read_word_lines(file_);
    for (const TextLine& line : lines) check(Words(file_, line));
    // Edges may stand above their vertices.
    for (const std::string_view tag : {kVertex, kEdge, kFix}) {
      for (const TextLine& line : lines) add(tag, Words(file_, line));
    }
    if (graph_.nodes().empty()) {
      throw InputError(file_, fmt::format("no {} in it; is it a pose graph?", kVertex));
    }
    return with_kinds(graph_);
  }

  [[nodiscard]] std::vector<std::string> notes() const {
    const std::string name = file_.filename().string();
    std::vector<std::string> notes;
    for (const Skipped& skipped : skipped_) {
      notes.push_back(fmt::format("{}: {} line{} {} skipped, from line {} on: {} are not read",
                                  name, skipped.count, skipped.count == 1 ? "" : "s", skipped.tag,
                                  skipped.first_line, foreign_kind(skipped.tag)));
    }
    if (repaired_ > 0) {
      notes.push_back(fmt::format(
          "{}: {} information matri{} negative by rounding, the first in line {}: eigenvalues "
          "between -5e-6 of the largest and 0 are taken as 0",
          name, repaired_, repaired_ == 1 ? "x is" : "ces are", first_repaired_));
    }
    return notes;
  }

 private:
  /// Lines of one tag that are not read.
  struct Skipped {
    std::string tag;
    std::size_t count = 0;
    long first_line = 0;
  };

  void check(Words words) {
    const std::string& tag = words.tag();
    if (tag == kVertex || tag == kEdge || tag == kFix) return;
    const std::string_view kind = foreign_kind(tag);
    if (is_planar(tag) || kind.empty()) fail_unknown(words);
    if (foreign_ == ForeignEntries::kRefuse) {
      words.fail(fmt::format("{}: {} are not read; remove the line", tag, kind));
    }
    if (tag.starts_with("VERTEX") && words.count() > 0) landmarks_.insert(words.id());
    auto entry = std::find_if(skipped_.begin(), skipped_.end(),
                              [&](const Skipped& skipped) { return skipped.tag == tag; });
    if (entry == skipped_.end()) entry = skipped_.insert(entry, {tag, 0, words.line()});
    ++entry->count;
  }

  /// Adds the entry of a line if it has this tag.
  void add(std::string_view tag, Words words) {
    if (words.tag() != tag) return;
    try {
      if (tag == kVertex) graph_.add_node(parse_vertex(words));
      if (tag == kEdge) add_edge(words);
      if (tag == kFix) fix(words);
    } catch (const DataError& error) {
      words.fail(error.what());
    }
  }

  void add_edge(Words& words) {
    PoseGraphEdge edge = parse_edge(words);
    if (repair_rounding(edge.information) && repaired_++ == 0) first_repaired_ = words.line();
    graph_.add_edge(edge);
  }

  void fix(Words& words) {
    if (words.count() == 0) words.fail("FIX names no vertex; remove the line");
    for (std::size_t i = 0; i < words.count(); ++i) {
      const NodeId id = words.id();
      if (!landmarks_.contains(id)) graph_.set_fixed(graph_.index_of(id), true);
    }
  }

  const std::filesystem::path& file_;
  ForeignEntries foreign_;
  PoseGraph graph_;
  std::vector<Skipped> skipped_;  // in the order of their first lines
  std::set<NodeId> landmarks_;
  std::size_t repaired_ = 0;
  long first_repaired_ = 0;
};

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

PoseGraph read_g2o(const std::filesystem::path& file, std::vector<std::string>& notes,
                   ForeignEntries foreign) {
  GraphReader reader(file, foreign);
  PoseGraph graph = reader.read();
  for (std::string& note : reader.notes()) notes.push_back(std::move(note));
  return graph;
}

PoseGraph read_g2o(const std::filesystem::path& file) {
  std::vector<std::string> notes;
  return read_g2o(file, notes, ForeignEntries::kRefuse);
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
