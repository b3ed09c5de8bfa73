// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cvo_slam/core/options.h"

namespace cvo_slam {

/// Sets the option that an argument "key=value" of --set names. Throws OptionError where it is
/// malformed, with `example` as one that is not, or where the set refuses it.
void apply_setting(const OptionSet& options, const std::string& setting,
                   const std::string& example);

}  // namespace cvo_slam
