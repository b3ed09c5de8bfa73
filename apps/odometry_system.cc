// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/odometry_system.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "cvo_slam/apps/opencv_odometry.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/frontend/tracker.h"

namespace cvo_slam {
namespace {

using SystemPointer = std::unique_ptr<OdometrySystem>;

class TrackerSystem final : public OdometrySystem {
 public:
  TrackerSystem(const Camera& camera, const TrackerOptions& options) : tracker_(camera, options) {}

  std::optional<SE3> track(const RgbdFrame& frame) override {
    const FrameRecord record = tracker_.track(frame).record;
    if (record.status == TrackingStatus::kLost) return std::nullopt;
    return record.T_world_camera;
  }

 private:
  Tracker tracker_;
};

struct Entry {
  std::string name;
  std::string description;
  std::function<SystemPointer(const Camera&, const TrackerOptions&)> make;
};

Entry opencv_entry(const std::string& name, const std::string& type, OpencvMethod method) {
  return {name, "cv::rgbd::" + type + ", frame to frame, on undistorted images",
          [method](const Camera& camera, const TrackerOptions&) {
            return make_opencv_odometry(method, camera);
          }};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> table = {
      {"ours", "cvo_slam::Tracker",
       [](const Camera& camera, const TrackerOptions& options) -> SystemPointer {
         return std::make_unique<TrackerSystem>(camera, options);
       }},
      {"paper", "cvo_slam::Tracker with the CVO paper's protocol, frame to frame",
       [](const Camera& camera, const TrackerOptions&) -> SystemPointer {
         return std::make_unique<TrackerSystem>(camera, paper_options());
       }},
      opencv_entry("rgbd", "RgbdOdometry", OpencvMethod::kRgbd),
      opencv_entry("rgbd_icp", "RgbdICPOdometry", OpencvMethod::kRgbdIcp),
      opencv_entry("icp", "ICPOdometry", OpencvMethod::kIcp),
  };
  return table;
}

const Entry& find_entry(const std::string& name) {
  const auto found = std::find_if(entries().begin(), entries().end(),
                                  [&](const Entry& entry) { return entry.name == name; });
  if (found != entries().end()) return *found;
  throw OptionError(fmt::format("--systems: unknown system '{}'; {}", name,
                                suggestion(name, odometry_system_names())));
}

}  // namespace

std::vector<std::string> odometry_system_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries()) names.push_back(entry.name);
  return names;
}

std::vector<Contestant> make_contestants(const std::vector<std::string>& names,
                                         const Camera& camera, const TrackerOptions& options) {
  std::vector<Contestant> contestants;
  for (const std::string& name : names) {
    const Entry& entry = find_entry(name);
    if (std::count(names.begin(), names.end(), name) > 1) {
      throw OptionError(fmt::format("--systems: '{}' is named twice; name each system once", name));
    }
    contestants.push_back({entry.name, entry.description, entry.make(camera, options)});
  }
  return contestants;
}

}  // namespace cvo_slam
