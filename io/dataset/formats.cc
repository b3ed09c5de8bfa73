// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "cvo_slam/io/dataset/formats_internal.h"

namespace cvo_slam {
namespace {

constexpr std::array kFormats = {
    &kTumFormat,
    &kSevenScenesFormat,
    &kImageFoldersFormat,
};

}  // namespace

std::span<const DatasetFormat* const> all_dataset_formats() { return kFormats; }

std::string dataset_formats() {
  std::string text;
  for (const DatasetFormat* format : kFormats) {
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", format->name, format->layout);
  }
  return text;
}

std::string folder_name(const std::filesystem::path& folder) {
  return std::filesystem::canonical(folder).filename().string();
}

Timestamp stamp_of_frame(std::int64_t number, double frame_rate) {
  constexpr std::int64_t kMicrosecond = 1000;
  return Timestamp(std::llround(static_cast<double>(number) * 1e6 / frame_rate) * kMicrosecond);
}

}  // namespace cvo_slam
