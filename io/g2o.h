// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// Reads a pose graph in g2o format: a line an entry,
///
///   VERTEX_SE3:QUAT id  x y z  qx qy qz qw
///   EDGE_SE3:QUAT from to  x y z  qx qy qz qw  and the 21 values of the upper triangle, by rows,
///   of
///                          the information in the order [translation; rotation]
///   FIX id...
///
/// in any order; '#' starts a comment. Matrices are taken as they stand, neither permuted nor
/// scaled: it is between_residual() in core/pose_graph.h that says what they are the information
/// of. The format does not know kinds of edges: from a vertex to the one with the next larger id is
/// taken for odometry, and any other edge for a loop, which may be wrong (robust).
///
/// Throws InputError, with the number of the line, for an unknown entry (and says so of planar
/// graphs), a wrong number of values, a value that is not a finite number, a quaternion of length
/// zero, a vertex that is there twice or not at all, an edge from a vertex to itself, an
/// information matrix that is not positive semi-definite; and for a file without any vertex.
[[nodiscard]] PoseGraph read_g2o(const std::filesystem::path& file);

/// Writes a pose graph in g2o format, with as many digits as numbers have: reading the file and
/// writing it again gives the same bytes. Throws OutputError.
void write_g2o(const std::filesystem::path& file, const PoseGraph& graph);

}  // namespace cvo_slam
