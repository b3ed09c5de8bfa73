// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {

/// The vocabulary of config/vocabulary/, whose bytes are part of this library: there is no file
/// that a program could fail to find. Made anew by each call; share it.
[[nodiscard]] std::shared_ptr<const Vocabulary> builtin_vocabulary();

}  // namespace cvo_slam
