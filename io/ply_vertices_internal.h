// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string_view>

#include "cvo_slam/io/ply_header_internal.h"

namespace cvo_slam {

/// Values of a vertex, indexed by PlyMeaning; 0 for what the file does not have.
class PlyVertex {
 public:
  [[nodiscard]] double& operator[](PlyMeaning meaning) {
    return values_[static_cast<std::size_t>(meaning)];
  }
  [[nodiscard]] double operator[](PlyMeaning meaning) const {
    return values_[static_cast<std::size_t>(meaning)];
  }

 private:
  std::array<double, kPlyMeanings> values_{};
};

/// Calls a function with each vertex of `text`, the content of `file`, in order. Throws InputError
/// if the file ends before its last vertex: a binary file before the first call.
void for_each_vertex(const std::filesystem::path& file, const PlyHeader& header,
                     std::string_view text, const std::function<void(const PlyVertex&)>& visit);

}  // namespace cvo_slam
