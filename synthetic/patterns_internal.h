// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "cvo_slam/synthetic/texture.h"

namespace cvo_slam::synthetic {

inline LinearColor mix(const LinearColor& a, const LinearColor& b, double share) {
  return a + share * (b - a);
}

/// Returns the wider side of the pixel's footprint [m].
[[nodiscard]] double footprint(const SurfacePoint& p);

// The printed patterns. Each function returns the reflectance of one pattern; the axes of the
// texture are already turned.

[[nodiscard]] LinearColor text(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] LinearColor poster(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] LinearColor spine(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] LinearColor landscape(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] LinearColor collage(const Texture& texture, const SurfacePoint& p);

}  // namespace cvo_slam::synthetic
