// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "cvo_slam/core/options.h"
#include "cvo_slam/core/parallel.h"
#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {

struct TrainingOptions {
  int branching = 9;
  int levels = 5;
  int iterations = 10;
  int seed = 1;
};

[[nodiscard]] OptionSet describe(TrainingOptions& options);

/// Makes a vocabulary of the descriptors of many images, one list an image: hierarchical k-majority
/// clustering, and as a word's weight the logarithm of how many times rarer it is than an image
/// (idf). The same descriptors and options give the same vocabulary on any number of threads.
/// Throws DataError where there are no descriptors, OptionError for a bad option.
[[nodiscard]] Vocabulary train_vocabulary(std::span<const std::vector<Descriptor>> images,
                                          const TrainingOptions& options = {},
                                          const Executor& executor = Executor());

}  // namespace cvo_slam
