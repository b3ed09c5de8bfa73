// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// Pairs (index in a, index in b) of stamps that differ by at most `max_difference` [s]: the
/// closest pair of all first, then the closest of what is left, and so on; no stamp is in two
/// pairs. Equal differences are taken in the order of a, then of b. Both lists ascend, and so does
/// the result.
std::vector<std::pair<std::size_t, std::size_t>> associate_stamps(const std::vector<Timestamp>& a,
                                                                  const std::vector<Timestamp>& b,
                                                                  double max_difference);

}  // namespace cvo_slam
