// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/synthetic/view_internal.h"

namespace cvo_slam::synthetic {

/// A camera that moves through a scene in which things may move. Refers to all of them.
struct Motion {
  const Scene& scene;
  const PinholeCamera& camera;
  const std::function<SE3(double seconds)>& T_world_camera;
};

/// The views of an image's rows under a rolling shutter: the middle of the image is seen at
/// `seconds`, the last row `readout` [s] after the first.
class RowViews {
 public:
  RowViews(const Motion& motion, double seconds, double readout);

  /// Valid until the next but one row is asked for.
  [[nodiscard]] const View& of_row(int y);
  /// When a row is seen [s].
  [[nodiscard]] double seconds_of_row(int y) const;

 private:
  /// A scene at an instant with the view of it.
  struct Snapshot {
    Snapshot(const Motion& motion, bool moves, double seconds, const RowRange& rows);
    Snapshot(const Snapshot&) = delete;  // the view refers to the scene beside it
    Snapshot& operator=(const Snapshot&) = delete;
    std::optional<Scene> moved;
    View view;
  };

  Motion motion_;
  double seconds_;
  double readout_;
  bool moves_;  ///< whether anything in the scene does
  std::array<std::optional<Snapshot>, 2> snapshots_;
};

}  // namespace cvo_slam::synthetic
