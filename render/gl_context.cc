// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstdint>
#include <utility>

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/render/gl_context_internal.h"

namespace cvo_slam::render {
namespace {

/// A shared library that is loaded at run time, so that programs run without it and embedders do
/// not link it. It stays loaded until the process ends: Mesa leaves thread destructors behind.
class DynamicLibrary {
 public:
  /// Throws Error, which ends with `advice`, if the library cannot be loaded.
  DynamicLibrary(std::string name, const std::string& advice)
      : name_(std::move(name)), handle_(dlopen(name_.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) throw Error(fmt::format("{} cannot be loaded; {}", name_, advice));
  }

  /// Returns a function of the library. Throws Error if there is none of that name.
  template <typename Function>
  [[nodiscard]] Function function(const char* name) const {
    void* address = dlsym(handle_, name);
    if (address == nullptr) {
      throw Error(fmt::format("{} has no function {}; use another renderer", name_, name));
    }
    return reinterpret_cast<Function>(address);
  }

 private:
  std::string name_;
  void* handle_;
};

/// Everything is drawn into a framebuffer object, but OSMesa needs an image of its own [px].
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

// The part of EGL 1.5 and of EGL_MESA_platform_surfaceless that is used. Its own header would
// include those of X11.
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
      throw Error("EGL gives no display without a surface; use the renderer osmesa or splat");
    }
    create_context();
  }

  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  // The display stays: EGL has one for the whole process.
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
    // Without a surface no configuration is needed (EGL_KHR_no_config_context).
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

template <typename Function>
Function find(const GlContext& context, const char* name) {
  void* function = context.function(name);
  if (function == nullptr) {
    throw Error(fmt::format("this OpenGL has no function {}; use the renderer splat", name));
  }
  return reinterpret_cast<Function>(function);
}

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context(const std::string& library) {
  return std::make_unique<OsmesaContext>(library);
}

std::unique_ptr<GlContext> make_egl_context(const std::string& library) {
  return std::make_unique<EglContext>(library);
}

GlFunctions::GlFunctions(const GlContext& context)
    : GetString(find<decltype(GetString)>(context, "glGetString")),
      GetIntegerv(find<decltype(GetIntegerv)>(context, "glGetIntegerv")),
      GetError(find<decltype(GetError)>(context, "glGetError")),
      Viewport(find<decltype(Viewport)>(context, "glViewport")),
      Enable(find<decltype(Enable)>(context, "glEnable")),
      DepthFunc(find<decltype(DepthFunc)>(context, "glDepthFunc")),
      ClearColor(find<decltype(ClearColor)>(context, "glClearColor")),
      Clear(find<decltype(Clear)>(context, "glClear")),
      DrawArrays(find<decltype(DrawArrays)>(context, "glDrawArrays")),
      ReadPixels(find<decltype(ReadPixels)>(context, "glReadPixels")),
      PixelStorei(find<decltype(PixelStorei)>(context, "glPixelStorei")),
      CreateShader(find<decltype(CreateShader)>(context, "glCreateShader")),
      ShaderSource(find<decltype(ShaderSource)>(context, "glShaderSource")),
      CompileShader(find<decltype(CompileShader)>(context, "glCompileShader")),
      DeleteShader(find<decltype(DeleteShader)>(context, "glDeleteShader")),
      CreateProgram(find<decltype(CreateProgram)>(context, "glCreateProgram")),
      AttachShader(find<decltype(AttachShader)>(context, "glAttachShader")),
      BindAttribLocation(find<decltype(BindAttribLocation)>(context, "glBindAttribLocation")),
      LinkProgram(find<decltype(LinkProgram)>(context, "glLinkProgram")),
      GetProgramiv(find<decltype(GetProgramiv)>(context, "glGetProgramiv")),
      UseProgram(find<decltype(UseProgram)>(context, "glUseProgram")),
      DeleteProgram(find<decltype(DeleteProgram)>(context, "glDeleteProgram")),
      GetUniformLocation(find<decltype(GetUniformLocation)>(context, "glGetUniformLocation")),
      Uniform2f(find<decltype(Uniform2f)>(context, "glUniform2f")),
      VertexAttribPointer(find<decltype(VertexAttribPointer)>(context, "glVertexAttribPointer")),
      EnableVertexAttribArray(
          find<decltype(EnableVertexAttribArray)>(context, "glEnableVertexAttribArray")),
      DisableVertexAttribArray(
          find<decltype(DisableVertexAttribArray)>(context, "glDisableVertexAttribArray")),
      GenFramebuffers(find<decltype(GenFramebuffers)>(context, "glGenFramebuffers")),
      BindFramebuffer(find<decltype(BindFramebuffer)>(context, "glBindFramebuffer")),
      DeleteFramebuffers(find<decltype(DeleteFramebuffers)>(context, "glDeleteFramebuffers")),
      FramebufferRenderbuffer(
          find<decltype(FramebufferRenderbuffer)>(context, "glFramebufferRenderbuffer")),
      CheckFramebufferStatus(
          find<decltype(CheckFramebufferStatus)>(context, "glCheckFramebufferStatus")),
      GenRenderbuffers(find<decltype(GenRenderbuffers)>(context, "glGenRenderbuffers")),
      BindRenderbuffer(find<decltype(BindRenderbuffer)>(context, "glBindRenderbuffer")),
      RenderbufferStorage(find<decltype(RenderbufferStorage)>(context, "glRenderbufferStorage")),
      DeleteRenderbuffers(find<decltype(DeleteRenderbuffers)>(context, "glDeleteRenderbuffers")) {}

}  // namespace cvo_slam::render
