// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/render/gl_context_internal.h"
#include "cvo_slam/render/renderers_internal.h"

namespace cvo_slam::render {
namespace {

// Positions are pixels. The upper row of the image is the lower row of OpenGL, so that nothing
// needs to be flipped.
constexpr const char* kSplatVertexShader = R"(#version 120
uniform vec2 size;
attribute vec3 position;
attribute vec3 shape;   // radius, slopes
attribute vec4 color;   // blue, green, red
varying vec3 ellipse;
varying vec2 center;
void main() {
  gl_Position = vec4((2.0 * position.xy + 1.0) / size - 1.0, 2.0 * position.z - 1.0, 1.0);
  gl_PointSize = 2.0 * shape.x + 1.0;
  gl_FrontColor = vec4(color.bgr, 1.0);
  ellipse = shape;
  center = position.xy;
}
)";

constexpr const char* kSplatFragmentShader = R"(#version 120
varying vec3 ellipse;
varying vec2 center;
void main() {
  vec2 d = gl_FragCoord.xy - 0.5 - center;
  float rise = dot(ellipse.yz, d);
  if (dot(d, d) + rise * rise > ellipse.x * ellipse.x) discard;
  gl_FragColor = gl_Color;
}
)";

constexpr const char* kTriangleVertexShader = R"(#version 120
uniform vec2 size;
attribute vec3 position;
attribute vec4 color;
void main() {
  gl_Position = vec4((2.0 * position.xy + 1.0) / size - 1.0, 2.0 * position.z - 1.0, 1.0);
  gl_FrontColor = vec4(color.bgr, 1.0);
}
)";

constexpr const char* kTriangleFragmentShader = R"(#version 120
void main() { gl_FragColor = gl_Color; }
)";

enum Attribute : GLuint { kPosition = 0, kColor = 1, kShape = 2 };

/// A linked pair of shaders. It must not outlive the binding of the context.
class Program {
 public:
  Program(const GlFunctions& gl, const char* vertex, const char* fragment)
      : gl_(gl), id_(gl.CreateProgram()) {
    attach(GL_VERTEX_SHADER, vertex);
    attach(GL_FRAGMENT_SHADER, fragment);
    gl_.BindAttribLocation(id_, kPosition, "position");
    gl_.BindAttribLocation(id_, kColor, "color");
    gl_.BindAttribLocation(id_, kShape, "shape");
    gl_.LinkProgram(id_);
    GLint linked = 0;
    gl_.GetProgramiv(id_, GL_LINK_STATUS, &linked);
    linked_ = linked != 0;
  }
  ~Program() { gl_.DeleteProgram(id_); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use(cv::Size size) const {
    if (!linked_) throw Error("this OpenGL cannot compile the shaders; use the renderer splat");
    gl_.UseProgram(id_);
    gl_.Uniform2f(gl_.GetUniformLocation(id_, "size"), static_cast<float>(size.width),
                  static_cast<float>(size.height));
  }

 private:
  void attach(GLenum kind, const char* source) const {
    const GLuint shader = gl_.CreateShader(kind);
    gl_.ShaderSource(shader, 1, &source, nullptr);
    gl_.CompileShader(shader);
    gl_.AttachShader(id_, shader);
    gl_.DeleteShader(shader);  // takes effect when the program is deleted
  }

  const GlFunctions& gl_;
  GLuint id_;
  bool linked_ = false;
};

/// The colour and depth buffers of an image. It must not outlive the binding of the context.
class Framebuffer {
 public:
  Framebuffer(const GlFunctions& gl, cv::Size size) : gl_(gl) {
    gl_.GenFramebuffers(1, &id_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, id_);
    attach(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0, size);
    attach(depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, size);
    complete_ = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  ~Framebuffer() {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.DeleteRenderbuffers(1, &color_);
    gl_.DeleteRenderbuffers(1, &depth_);
    gl_.DeleteFramebuffers(1, &id_);
  }
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  [[nodiscard]] bool complete() const { return complete_; }

 private:
  void attach(GLuint& buffer, GLenum format, GLenum attachment, cv::Size size) const {
    gl_.GenRenderbuffers(1, &buffer);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, format, size.width, size.height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  }

  const GlFunctions& gl_;
  GLuint id_ = 0;
  GLuint color_ = 0;
  GLuint depth_ = 0;
  bool complete_ = false;
};

/// Binds a context during a scope.
class Binding {
 public:
  explicit Binding(GlContext& context) : context_(context) { context_.bind(); }
  ~Binding() { context_.release(); }
  Binding(const Binding&) = delete;
  Binding& operator=(const Binding&) = delete;

 private:
  GlContext& context_;
};

class GlRenderer : public Renderer {
 public:
  GlRenderer(std::string name, std::unique_ptr<GlContext> context)
      : name_(std::move(name)), context_(std::move(context)) {
    const Binding binding(*context_);
    const GlFunctions gl(*context_);
    const auto* device = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    if (device != nullptr) name_ += fmt::format(" ({})", device);
  }

  [[nodiscard]] std::string name() const override { return name_; }

  [[nodiscard]] Raster draw(const Primitives& primitives, cv::Size size,
                            Color background) override {
    const Binding binding(*context_);
    const GlFunctions gl(*context_);
    check_size(gl, size);
    const Framebuffer framebuffer(gl, size);
    if (!framebuffer.complete()) fail(size);
    clear(gl, size, background);
    draw_splats(gl, primitives.splats, size);
    draw_triangles(gl, primitives.corners, size);
    return read(gl, size);
  }

 private:
  [[noreturn]] void fail(cv::Size size) const {
    throw Error(
        fmt::format("{} cannot draw {}x{} pixels; choose a smaller picture or the renderer "
                    "splat",
                    name_, size.width, size.height));
  }

  void check_size(const GlFunctions& gl, cv::Size size) const {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    if (size.width > most || size.height > most) fail(size);
  }

  static void clear(const GlFunctions& gl, cv::Size size, Color background) {
    gl.Viewport(0, 0, size.width, size.height);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_VERTEX_PROGRAM_POINT_SIZE);
    gl.DepthFunc(GL_LESS);
    constexpr float kLevel = 255;
    gl.ClearColor(static_cast<float>(background.red) / kLevel,
                  static_cast<float>(background.green) / kLevel,
                  static_cast<float>(background.blue) / kLevel, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }

  static void set_array(const GlFunctions& gl, Attribute attribute, GLint count, GLenum type,
                        std::size_t stride, const void* first) {
    gl.EnableVertexAttribArray(attribute);
    gl.VertexAttribPointer(attribute, count, type, type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE,
                           static_cast<GLsizei>(stride), first);
  }

  static void draw_splats(const GlFunctions& gl, const std::vector<Splat>& splats, cv::Size size) {
    if (splats.empty()) return;
    const Program program(gl, kSplatVertexShader, kSplatFragmentShader);
    program.use(size);
    // A driver may copy all that it is given at once.
    constexpr std::size_t kBatch = 1U << 18U;
    for (std::size_t begin = 0; begin < splats.size(); begin += kBatch) {
      const Splat* first = splats.data() + begin;
      set_array(gl, kPosition, 3, GL_FLOAT, sizeof(Splat), &first->x);
      set_array(gl, kShape, 3, GL_FLOAT, sizeof(Splat), &first->radius);
      set_array(gl, kColor, 4, GL_UNSIGNED_BYTE, sizeof(Splat), first->color.data());
      gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(std::min(kBatch, splats.size() - begin)));
    }
    gl.DisableVertexAttribArray(kShape);
  }

  static void draw_triangles(const GlFunctions& gl, const std::vector<Corner>& corners,
                             cv::Size size) {
    if (corners.empty()) return;
    const Program program(gl, kTriangleVertexShader, kTriangleFragmentShader);
    program.use(size);
    set_array(gl, kPosition, 3, GL_FLOAT, sizeof(Corner), &corners[0].x);
    set_array(gl, kColor, 4, GL_UNSIGNED_BYTE, sizeof(Corner), corners[0].color.data());
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size() / 3 * 3));
  }

  [[nodiscard]] Raster read(const GlFunctions& gl, cv::Size size) const {
    Raster raster{cv::Mat(size, CV_8UC3), cv::Mat(size, CV_32FC1)};
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.ReadPixels(0, 0, size.width, size.height, GL_BGR, GL_UNSIGNED_BYTE, raster.color.data);
    gl.ReadPixels(0, 0, size.width, size.height, GL_DEPTH_COMPONENT, GL_FLOAT, raster.depth.data);
    if (gl.GetError() != GL_NO_ERROR) fail(size);
    return raster;
  }

  std::string name_;
  std::unique_ptr<GlContext> context_;
};

static_assert(offsetof(Splat, depth) == offsetof(Splat, x) + 2 * sizeof(float) &&
                  offsetof(Splat, slope_y) == offsetof(Splat, radius) + 2 * sizeof(float) &&
                  offsetof(Corner, depth) == offsetof(Corner, x) + 2 * sizeof(float),
              "a vector of a shader is three members in a row");

}  // namespace

std::unique_ptr<Renderer> make_gl_renderer(std::string name, std::unique_ptr<GlContext> context) {
  return std::make_unique<GlRenderer>(std::move(name), std::move(context));
}

}  // namespace cvo_slam::render
