// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/simd.h"

#include <cstdint>

#include <fmt/format.h>
#include <hwy/targets.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/pair_sums_internal.h"

namespace cvo_slam {
namespace {

/// Returns Highway's bit of a path; 0 if this processor's family has none.
std::int64_t target_of(SimdPath path) {
  switch (path) {
    case SimdPath::kBest:
      return 0;
    case SimdPath::kScalar:
      return HWY_EMU128 | HWY_SCALAR;  // Highway compiles one of the two
#if HWY_ARCH_X86
    case SimdPath::kSse4:
      return HWY_SSE4;
    case SimdPath::kAvx2:
      return HWY_AVX2;
    case SimdPath::kAvx512:
      return HWY_AVX3;
#else
    default:
      return 0;
#endif
  }
  return 0;
}

std::string name_of(SimdPath path) {
  for (const auto& [name, candidate] : simd_path_names()) {
    if (candidate == path) return name;
  }
  return "?";
}

}  // namespace

void pin_simd(SimdPath path) {
  hwy::DisableTargets(0);
  const std::int64_t target = target_of(path);
  if (path != SimdPath::kBest) {
    const std::int64_t supported = hwy::SupportedTargets() | HWY_EMU128 | HWY_SCALAR;
    if ((supported & compiled_simd_targets() & target) == 0) {
      throw OptionError(
          fmt::format("simd={}: this CPU does not have it; take 'best'", name_of(path)));
    }
    hwy::DisableTargets(~target);
  }
  hwy::GetChosenTarget().DeInit();
}

std::string simd_in_use() { return hwy::TargetName(simd_target_in_use()); }

const std::vector<std::pair<std::string, SimdPath>>& simd_path_names() {
  static const std::vector<std::pair<std::string, SimdPath>> names = {
      {"best", SimdPath::kBest},
      {"scalar", SimdPath::kScalar},
      {"sse4", SimdPath::kSse4},
      {"avx2", SimdPath::kAvx2},
      {"avx512", SimdPath::kAvx512}};
  return names;
}

}  // namespace cvo_slam
