// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/render/renderer.h"

#include "cvo_slam/core/error.h"
#include "cvo_slam/render/renderers_internal.h"

namespace cvo_slam::render {
namespace {

std::unique_ptr<Renderer> make_osmesa_or_splat() {
  try {
    return make_gl_renderer("osmesa", make_osmesa_context());
  } catch (const Error&) {
    return std::make_unique<SplatRenderer>();
  }
}

}  // namespace

const std::vector<std::pair<std::string, RendererKind>>& renderer_names() {
  static const std::vector<std::pair<std::string, RendererKind>> names = {
      {"auto", RendererKind::kAuto},
      {"osmesa", RendererKind::kOsmesa},
      {"egl", RendererKind::kEgl},
      {"splat", RendererKind::kSplat}};
  return names;
}

std::unique_ptr<Renderer> make_renderer(RendererKind kind) {
  switch (kind) {
    case RendererKind::kAuto:
      return make_osmesa_or_splat();
    case RendererKind::kOsmesa:
      return make_gl_renderer("osmesa", make_osmesa_context());
    case RendererKind::kEgl:
      return make_gl_renderer("egl", make_egl_context());
    case RendererKind::kSplat:
      return std::make_unique<SplatRenderer>();
  }
  return nullptr;
}

}  // namespace cvo_slam::render
