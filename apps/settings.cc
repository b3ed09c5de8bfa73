// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/settings.h"

#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {

void apply_setting(const OptionSet& options, const std::string& setting,
                   const std::string& example) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) {
    throw OptionError(fmt::format("--set {} must be key=value, e.g. {}", setting, example));
  }
  options.set(setting.substr(0, equals), setting.substr(equals + 1));
}

}  // namespace cvo_slam
