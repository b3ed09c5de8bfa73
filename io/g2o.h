// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// What to do with entries of a g2o file that are no part of a pose graph.
enum class ForeignEntries {
  kSkip,    ///< skips them; a note says which and how many
  kRefuse,  ///< throws InputError with the line of the first
};

/// Reads a pose graph in g2o format, one entry per line:
///
///     VERTEX_SE3:QUAT id  x y z  qx qy qz qw
///     EDGE_SE3:QUAT from to  x y z  qx qy qz qw  i11 i12 ... i66
///     FIX id...
///
/// i11 ... i66 are the 21 values of the upper triangle of the information matrix, row by row, in
/// the order [translation; rotation]. The entries may be in any order; '#' starts a comment.
/// Matrices are read as they are, neither permuted nor scaled: which residual they belong to is
/// said in core's pose graph. Eigenvalues that are negative by rounding, above -5e-6 of the largest
/// one, become 0.
/// The format does not store kinds of edges: an edge between a vertex and the one with the next
/// larger id, in either direction, is read as odometry, every other edge as a loop that may be
/// wrong (robust).
///
/// Foreign entries are parameters (PARAMS_...), priors (EDGE_SE3_PRIOR, ...) and landmarks with
/// their measurements (VERTEX_TRACKXYZ, EDGE_SE3_TRACKXYZ, ...). Adds a line to `notes` for each
/// kind that was skipped, and one if information matrices were changed.
///
/// Throws InputError with the line for an unknown entry (planar graphs are named as such), a wrong
/// number of values, a value that is not a finite number, a quaternion of length zero, a vertex
/// that is given twice or missing, an edge from a vertex to itself, or an information matrix that
/// is not positive semi-definite; and without a line for a file that has no vertex.
[[nodiscard]] PoseGraph read_g2o(const std::filesystem::path& file, std::vector<std::string>& notes,
                                 ForeignEntries foreign = ForeignEntries::kSkip);

/// Reads a pose graph like read_g2o() above for a caller without a place for notes: foreign entries
/// are refused.
[[nodiscard]] PoseGraph read_g2o(const std::filesystem::path& file);

/// Writes a pose graph in g2o format with all digits: reading the file and writing it again gives
/// the same bytes. Throws OutputError.
void write_g2o(const std::filesystem::path& file, const PoseGraph& graph);

}  // namespace cvo_slam
