// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include <GL/osmesa.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/render/dynamic_library_internal.h"
#include "cvo_slam/render/gl_context_internal.h"

namespace cvo_slam::render {
namespace {

/// Everything is drawn into a framebuffer object; OSMesa wants an image of its own nevertheless.
constexpr GLsizei kUnusedSize = 16;

class OsmesaContext : public GlContext {
 public:
  explicit OsmesaContext(const std::string& library)
      : library_(library,
                 "install Debian's package libosmesa6, or choose the renderer splat, which needs "
                 "no OpenGL"),
        make_current_(library_.function<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent")),
        get_function_(library_.function<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress")),
        context_(library_.function<decltype(&OSMesaCreateContextExt)>("OSMesaCreateContextExt")(
                     OSMESA_RGBA, 0, 0, 0, nullptr),
                 library_.function<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext")) {
    if (!context_) throw Error("OSMesa gives no context; use the renderer splat");
  }

  void bind() override {
    if (make_current_(context_.get(), unused_image_.data(), GL_UNSIGNED_BYTE, kUnusedSize,
                      kUnusedSize) == GL_FALSE) {
      throw Error("OSMesa's context cannot be made current; use the renderer splat");
    }
  }

  void release() override { make_current_(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

  [[nodiscard]] void* function(const char* name) const override {
    return reinterpret_cast<void*>(get_function_(name));
  }

 private:
  DynamicLibrary library_;
  decltype(&OSMesaMakeCurrent) make_current_;
  decltype(&OSMesaGetProcAddress) get_function_;
  std::array<unsigned char, std::size_t{4} * kUnusedSize * kUnusedSize> unused_image_{};
  std::unique_ptr<osmesa_context, decltype(&OSMesaDestroyContext)> context_;
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context(const std::string& library) {
  return std::make_unique<OsmesaContext>(library);
}

}  // namespace cvo_slam::render
