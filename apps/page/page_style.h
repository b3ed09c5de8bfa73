// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace cvo_slam {

/// The style sheet of reports, on screens (light and dark, wide and narrow) and on paper.
[[nodiscard]] std::string_view page_style();

}  // namespace cvo_slam
