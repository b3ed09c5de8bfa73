// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parsers of files that others write, each as a function of any bytes. libFuzzer looks for
// bytes that break them (`make fuzz`); what it found is replayed by the tests with any compiler.
#pragma once

#include <span>
#include <string_view>

namespace cvo_slam {

struct FuzzTarget {
  std::string_view name;  ///< also the name of its folder in tests/fuzz/corpus
  /// Parses the bytes. A parser may answer or throw an Error, and nothing else.
  void (*parse)(std::string_view bytes);
};

[[nodiscard]] std::span<const FuzzTarget> fuzz_targets();

/// Calls the parser of a target, which must exist, and catches Error.
void run_fuzz_target(std::string_view name, std::string_view bytes);

}  // namespace cvo_slam
