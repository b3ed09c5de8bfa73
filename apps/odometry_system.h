// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/tracker.h"

namespace cvo_slam {

/// An RGB-D odometry as `bench odometry` sees it.
class OdometrySystem {
 public:
  virtual ~OdometrySystem() = default;

  /// T_world_camera of the next frame; empty where the system lost it.
  [[nodiscard]] virtual std::optional<SE3> track(const RgbdFrame& frame) = 0;
};

/// One of the systems to compare.
struct Contestant {
  std::string name;                        ///< as in --systems
  std::string description;                 ///< for people
  std::unique_ptr<OdometrySystem> system;  ///< null where it is not built in
};

/// The names of all systems, in the order of the table.
[[nodiscard]] std::vector<std::string> odometry_system_names();

/// The systems of these names; `options` are for "ours" alone.
/// Throws OptionError for an unknown name (the message gives the nearest) or a bad option.
[[nodiscard]] std::vector<Contestant> make_contestants(const std::vector<std::string>& names,
                                                       const Camera& camera,
                                                       const TrackerOptions& options);

}  // namespace cvo_slam
