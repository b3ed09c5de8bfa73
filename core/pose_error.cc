// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/pose_error.h"

namespace cvo_slam {

PoseErrorStatistics summarize(const std::vector<PoseError>& errors) {
  std::vector<double> translations;
  std::vector<double> rotations;
  translations.reserve(errors.size());
  rotations.reserve(errors.size());
  for (const auto& error : errors) {
    translations.push_back(error.translation);
    rotations.push_back(error.rotation);
  }
  return {summarize(std::span<const double>(translations)),
          summarize(std::span<const double>(rotations))};
}

}  // namespace cvo_slam
