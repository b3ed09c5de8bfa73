// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reports as JSON, for programs. One source makes all of them: a source that includes
// nlohmann/json.hpp takes ten seconds to compile.
#pragma once

#include <string>

namespace cvo_slam {

class Dataset;
struct EvaluationReport;
struct FramePair;
struct FrameRegistration;
struct OdometryBenchmark;
struct RunReport;

// Each returns all figures of a report as one JSON object, indented by two spaces, without a new
// line at its end. Keys end in the unit ("translation_m", "rotation_deg").

[[nodiscard]] std::string json_text(const EvaluationReport& report);
[[nodiscard]] std::string json_text(const Dataset& data, const OdometryBenchmark& benchmark);
[[nodiscard]] std::string json_text(const FramePair& pair, const FrameRegistration& registration);
/// Includes the effective options.
[[nodiscard]] std::string json_text(const RunReport& report);

}  // namespace cvo_slam
