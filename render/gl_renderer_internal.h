// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "cvo_slam/render/gl_context_internal.h"
#include "cvo_slam/render/renderer.h"

namespace cvo_slam::render {

/// Draws with OpenGL 2.1 in the given context, which is bound while it draws and not longer.
/// Throws Error where it lacks a function or is not able to draw.
[[nodiscard]] std::unique_ptr<Renderer> make_gl_renderer(std::string name,
                                                         std::unique_ptr<GlContext> context);

}  // namespace cvo_slam::render
