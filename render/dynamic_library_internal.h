// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace cvo_slam::render {

/// A shared library that is loaded when it is asked for, so that a program runs where it is not
/// installed, and embedders do not link it. It stays loaded until the process ends: Mesa leaves
/// destructors of threads behind.
class DynamicLibrary {
 public:
  /// Throws Error that ends with `advice` where the library cannot be loaded.
  DynamicLibrary(std::string name, const std::string& advice);

  /// Throws Error where the library has no such function.
  template <typename Function>
  [[nodiscard]] Function function(const char* name) const {
    return reinterpret_cast<Function>(find(name));
  }

 private:
  [[nodiscard]] void* find(const char* name) const;

  std::string name_;
  void* handle_;
};

}  // namespace cvo_slam::render
