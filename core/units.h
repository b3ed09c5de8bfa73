// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>

namespace cvo_slam {

/// A radian in degrees, for people to read: inside, angles are in radians.
inline constexpr double kDegrees = 180 / std::numbers::pi;

}  // namespace cvo_slam
