// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/error.h"

#include <fmt/format.h>

namespace cvo_slam {

InputError::InputError(const std::filesystem::path& file, const std::string& problem)
    : Error(fmt::format("{}: {}", file.string(), problem)) {}

InputError::InputError(const std::filesystem::path& file, long line, const std::string& problem)
    : Error(fmt::format("{}:{}: {}", file.string(), line, problem)) {}

OutputError::OutputError(const std::filesystem::path& file, const std::string& problem)
    : Error(fmt::format("{}: {}", file.string(), problem)) {}

}  // namespace cvo_slam
