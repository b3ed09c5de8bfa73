// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/synthetic/texture.h"

namespace cvo_slam::synthetic {

inline Color mix(const Color& a, const Color& b, double share) { return a + share * (b - a); }

/// The wider side of the footprint [m].
[[nodiscard]] double footprint(const SurfacePoint& p);

/// A brightness factor about 1 from irregularities at all scales from 0.3 m (of plaster: as its
/// scale says) down to a 32nd of it.
[[nodiscard]] double mottle(const Texture& texture, const SurfacePoint& p);

/// Share of ink in [0, 1] on a page of text-like strokes with lines `line` [m] apart.
[[nodiscard]] double ink(std::uint32_t seed, double line, const SurfacePoint& p);

// One function a pattern, with the texture's axes already turned.
[[nodiscard]] Color wood(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] Color bricks(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] Color tiles(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] Color stripes(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] Color plaid(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] Color carpet(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] Color text(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] Color poster(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] Color spine(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] Color landscape(const Texture& texture, const SurfacePoint& p);
[[nodiscard]] Color collage(const Texture& texture, const SurfacePoint& p);

}  // namespace cvo_slam::synthetic
