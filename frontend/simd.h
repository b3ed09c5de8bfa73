// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cvo_slam {

/// The instruction set that registrations compute with. Results of different ones agree to single
/// precision; results of the same one are the same to the byte.
enum class SimdPath {
  kBest,    ///< the best one of this CPU
  kScalar,  ///< plain C++
  kSse4,
  kAvx2,
  kAvx512,
};

/// Pins the path for the whole process: call it before registrations run. Throws OptionError if
/// this CPU or this build does not have it.
void pin_simd(SimdPath path);

/// Returns the name of the path in use, as Highway spells it.
[[nodiscard]] std::string simd_in_use();

/// Returns all paths with their names on the command line.
[[nodiscard]] const std::vector<std::pair<std::string, SimdPath>>& simd_path_names();

}  // namespace cvo_slam
