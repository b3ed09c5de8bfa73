// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace cvo_slam {

/// The bytes as text of letters, digits, '+' and '/', padded with '=' (RFC 4648, section 4): what a
/// `data:` address of an image in SVG or HTML holds.
[[nodiscard]] std::string to_base64(std::string_view bytes);

}  // namespace cvo_slam
