// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/render/gl_functions_internal.h"

namespace cvo_slam::render {
namespace {

template <typename Function>
Function find(const GlContext& context, const char* name) {
  void* function = context.function(name);
  if (function == nullptr) {
    throw Error(fmt::format("this OpenGL has no function {}; use the renderer splat", name));
  }
  return reinterpret_cast<Function>(function);
}

}  // namespace

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
