// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include <GL/gl.h>
#include <GL/glext.h>

namespace cvo_slam::render {

/// An OpenGL context without a window.
class GlContext {
 public:
  virtual ~GlContext() = default;
  /// Makes the context current in the calling thread. Throws Error.
  virtual void bind() = 0;
  /// Leaves the thread without a context.
  virtual void release() = 0;
  /// Returns an OpenGL function; null if there is none of that name. The context must be bound.
  [[nodiscard]] virtual void* function(const char* name) const = 0;
};

inline constexpr const char* kOsmesaLibrary = "libOSMesa.so.8";
inline constexpr const char* kEglLibrary = "libEGL.so.1";

/// Return a context. Throw Error if the library is missing or gives no context.
[[nodiscard]] std::unique_ptr<GlContext> make_osmesa_context(
    const std::string& library = kOsmesaLibrary);
[[nodiscard]] std::unique_ptr<GlContext> make_egl_context(const std::string& library = kEglLibrary);

/// The functions of OpenGL 2.1 and of framebuffer objects that drawing needs, by their names
/// without "gl". They are looked up in the context and never linked: another library of the
/// process, such as OpenCV, may have loaded another OpenGL.
struct GlFunctions {
  /// `context` must be bound. Throws Error if a function is missing.
  explicit GlFunctions(const GlContext& context);

  decltype(&glGetString) GetString;
  decltype(&glGetIntegerv) GetIntegerv;
  decltype(&glGetError) GetError;
  decltype(&glViewport) Viewport;
  decltype(&glEnable) Enable;
  decltype(&glDepthFunc) DepthFunc;
  decltype(&glClearColor) ClearColor;
  decltype(&glClear) Clear;
  decltype(&glDrawArrays) DrawArrays;
  decltype(&glReadPixels) ReadPixels;
  decltype(&glPixelStorei) PixelStorei;
  PFNGLCREATESHADERPROC CreateShader;
  PFNGLSHADERSOURCEPROC ShaderSource;
  PFNGLCOMPILESHADERPROC CompileShader;
  PFNGLDELETESHADERPROC DeleteShader;
  PFNGLCREATEPROGRAMPROC CreateProgram;
  PFNGLATTACHSHADERPROC AttachShader;
  PFNGLBINDATTRIBLOCATIONPROC BindAttribLocation;
  PFNGLLINKPROGRAMPROC LinkProgram;
  PFNGLGETPROGRAMIVPROC GetProgramiv;
  PFNGLUSEPROGRAMPROC UseProgram;
  PFNGLDELETEPROGRAMPROC DeleteProgram;
  PFNGLGETUNIFORMLOCATIONPROC GetUniformLocation;
  PFNGLUNIFORM2FPROC Uniform2f;
  PFNGLVERTEXATTRIBPOINTERPROC VertexAttribPointer;
  PFNGLENABLEVERTEXATTRIBARRAYPROC EnableVertexAttribArray;
  PFNGLDISABLEVERTEXATTRIBARRAYPROC DisableVertexAttribArray;
  PFNGLGENFRAMEBUFFERSPROC GenFramebuffers;
  PFNGLBINDFRAMEBUFFERPROC BindFramebuffer;
  PFNGLDELETEFRAMEBUFFERSPROC DeleteFramebuffers;
  PFNGLFRAMEBUFFERRENDERBUFFERPROC FramebufferRenderbuffer;
  PFNGLCHECKFRAMEBUFFERSTATUSPROC CheckFramebufferStatus;
  PFNGLGENRENDERBUFFERSPROC GenRenderbuffers;
  PFNGLBINDRENDERBUFFERPROC BindRenderbuffer;
  PFNGLRENDERBUFFERSTORAGEPROC RenderbufferStorage;
  PFNGLDELETERENDERBUFFERSPROC DeleteRenderbuffers;
};

}  // namespace cvo_slam::render
