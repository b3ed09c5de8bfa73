// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// The longest time between neighbours that a drawn line joins [s]: longer means that some are
/// missing, and a line would show what nobody measured. `stamps` ascend.
[[nodiscard]] double longest_usual_step(const std::vector<Timestamp>& stamps);

}  // namespace cvo_slam
