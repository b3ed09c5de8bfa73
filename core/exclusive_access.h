// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "cvo_slam/core/error.h"

namespace cvo_slam {

/// A member function's way to the state behind the class's pointer: one function at a time, and
/// none after the object was moved from. `Impl` has a member `std::atomic_flag in_use`.
template <typename Impl>
class ExclusiveAccess {
 public:
  /// `name` is that of the class, for messages. Throws UsageError if another function is in the
  /// object, which only another thread can be, and if there is no object.
  ExclusiveAccess(const std::unique_ptr<Impl>& impl, const std::string& name) : impl_(impl.get()) {
    if (impl_ == nullptr) {
      throw UsageError("this " + name + " was moved from; use the one that it was moved to");
    }
    if (impl_->in_use.test_and_set()) {
      throw UsageError("another thread is in this " + name +
                       ", or it was called by its own observer; call it from "
                       "one thread at a time");
    }
  }
  ~ExclusiveAccess() { impl_->in_use.clear(); }
  ExclusiveAccess(const ExclusiveAccess&) = delete;
  ExclusiveAccess& operator=(const ExclusiveAccess&) = delete;

  /// Gives access to the members of `Impl`.
  Impl* operator->() const { return impl_; }

 private:
  Impl* impl_;
};

}  // namespace cvo_slam
