// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

namespace cvo_slam::render {

/// A context of OpenGL without a window.
class GlContext {
 public:
  virtual ~GlContext() = default;
  /// Makes it the calling thread's. Throws Error.
  virtual void bind() = 0;
  /// Leaves the thread without a context.
  virtual void release() = 0;
  /// A function of OpenGL; null where there is none of that name. Only while it is bound.
  [[nodiscard]] virtual void* function(const char* name) const = 0;
};

inline constexpr const char* kOsmesaLibrary = "libOSMesa.so.8";
inline constexpr const char* kEglLibrary = "libEGL.so.1";

/// Throw Error where the library is missing or gives no context.
[[nodiscard]] std::unique_ptr<GlContext> make_osmesa_context(
    const std::string& library = kOsmesaLibrary);
[[nodiscard]] std::unique_ptr<GlContext> make_egl_context(const std::string& library = kEglLibrary);

}  // namespace cvo_slam::render
