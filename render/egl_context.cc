// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstdint>

#include "cvo_slam/core/error.h"
#include "cvo_slam/render/dynamic_library_internal.h"
#include "cvo_slam/render/gl_context_internal.h"

namespace cvo_slam::render {
namespace {

// The part of EGL 1.5 and of EGL_MESA_platform_surfaceless that is used: its header would bring the
// headers of X11.
using EglDisplay = void*;
using EglContextHandle = void*;
using EglConfig = void*;
using EglBoolean = unsigned int;
using EglInteger = std::int32_t;
constexpr unsigned int kPlatformSurfaceless = 0x31DD;
constexpr unsigned int kOpenGlApi = 0x30A2;

class EglContext : public GlContext {
 public:
  explicit EglContext(const std::string& library)
      : library_(library,
                 "install Debian's package libegl1, or choose the renderer osmesa or splat") {
    display_ = library_.function<EglDisplay (*)(unsigned int, void*, const std::intptr_t*)>(
        "eglGetPlatformDisplay")(kPlatformSurfaceless, nullptr, nullptr);
    const bool ready = display_ != nullptr &&
                       library_.function<EglBoolean (*)(EglDisplay, EglInteger*, EglInteger*)>(
                           "eglInitialize")(display_, nullptr, nullptr) != 0;
    if (!ready) {
      throw Error("EGL has no display without a surface; use the renderer osmesa or splat");
    }
    create_context();
  }

  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  // The display is EGL's own, one for the whole process: it stays.
  ~EglContext() override {
    library_.function<EglBoolean (*)(EglDisplay, EglContextHandle)>("eglDestroyContext")(display_,
                                                                                         context_);
  }

  void bind() override {
    if (!make_current(context_)) {
      throw Error("EGL's context cannot be made current; use the renderer osmesa or splat");
    }
  }

  void release() override { make_current(nullptr); }

  [[nodiscard]] void* function(const char* name) const override {
    return library_.function<void* (*)(const char*)>("eglGetProcAddress")(name);
  }

 private:
  void create_context() {
    const bool bound =
        library_.function<EglBoolean (*)(unsigned int)>("eglBindAPI")(kOpenGlApi) != 0;
    // No configuration: there is no surface that it could describe (EGL_KHR_no_config_context).
    const auto create = library_.function<EglContextHandle (*)(
        EglDisplay, EglConfig, EglContextHandle, const EglInteger*)>("eglCreateContext");
    context_ = bound ? create(display_, nullptr, nullptr, nullptr) : nullptr;
    if (context_ == nullptr) {
      throw Error("EGL gives no context of OpenGL; use the renderer osmesa or splat");
    }
  }

  bool make_current(EglContextHandle context) {
    const auto set = library_.function<EglBoolean (*)(EglDisplay, void*, void*, EglContextHandle)>(
        "eglMakeCurrent");
    return set(display_, nullptr, nullptr, context) != 0;
  }

  DynamicLibrary library_;
  EglDisplay display_ = nullptr;
  EglContextHandle context_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context(const std::string& library) {
  return std::make_unique<EglContext>(library);
}

}  // namespace cvo_slam::render
