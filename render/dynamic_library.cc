// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include <dlfcn.h>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/render/dynamic_library_internal.h"

namespace cvo_slam::render {

DynamicLibrary::DynamicLibrary(std::string name, const std::string& advice)
    : name_(std::move(name)), handle_(dlopen(name_.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ == nullptr) {
    throw Error(fmt::format("{} cannot be loaded; {}", name_, advice));
  }
}

void* DynamicLibrary::find(const char* name) const {
  void* function = dlsym(handle_, name);
  if (function == nullptr) {
    throw Error(fmt::format("{} has no function {}; use another renderer", name_, name));
  }
  return function;
}

}  // namespace cvo_slam::render
