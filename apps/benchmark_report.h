// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "cvo_slam/apps/odometry_benchmark.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// Which frames of which sequence, by which protocol, and a table with a row for each system: a
/// list and a table in Markdown, aligned to be read as they are. A figure that does not exist is
/// "-".
[[nodiscard]] std::string to_table(const Dataset& data, const OdometryBenchmark& benchmark);

/// The same figures; keys end in the unit.
[[nodiscard]] nlohmann::ordered_json to_json(const Dataset& data,
                                             const OdometryBenchmark& benchmark);

}  // namespace cvo_slam
