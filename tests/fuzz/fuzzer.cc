// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The entry point of libFuzzer, for the target that the build names.
#include <cstddef>
#include <cstdint>

#include "cvo_slam/tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cvo_slam::run_fuzz_target(CVO_SLAM_FUZZ_TARGET, {reinterpret_cast<const char*>(data), size});
  return 0;
}
