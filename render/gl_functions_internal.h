// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include "cvo_slam/render/gl_context_internal.h"

namespace cvo_slam::render {

/// The functions of OpenGL 2.1 and of framebuffer objects that drawing needs, by their names
/// without "gl". They are looked up and never called by name: another library of the process, as
/// OpenCV's, may have brought another OpenGL.
struct GlFunctions {
  /// `context` must be bound. Throws Error where one is missing.
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
