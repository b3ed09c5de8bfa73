// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "cvo_slam/synthetic/row_views_internal.h"

namespace cvo_slam::synthetic {
namespace {

bool has_movers(const Scene& scene) {
  return std::any_of(scene.primitives.begin(), scene.primitives.end(),
                     [](const Primitive& primitive) { return primitive.swing.has_value(); });
}

}  // namespace

RowViews::Snapshot::Snapshot(const Motion& motion, bool moves, double seconds, const RowRange& rows)
    : moved(moves ? std::optional<Scene>(scene_at(motion.scene, seconds)) : std::nullopt),
      view(moved ? *moved : motion.scene, motion.camera, motion.T_world_camera(seconds), rows) {}

RowViews::RowViews(const Motion& motion, double seconds, double readout)
    : motion_(motion), seconds_(seconds), readout_(readout), moves_(has_movers(motion.scene)) {
  if (readout == 0) {
    snapshots_[0].emplace(motion, moves_, seconds, RowRange{0, motion.camera.height - 1});
  }
}

double RowViews::seconds_of_row(int y) const {
  const double share = static_cast<double>(y) / std::max(1, motion_.camera.height - 1);
  return seconds_ + readout_ * (share - 0.5);
}

const View& RowViews::of_row(int y) {
  if (readout_ == 0) return snapshots_[0]->view;
  auto& snapshot = snapshots_[static_cast<std::size_t>(y % 2)];
  snapshot.emplace(motion_, moves_, seconds_of_row(y), RowRange{y, y});
  return snapshot->view;
}

}  // namespace cvo_slam::synthetic
