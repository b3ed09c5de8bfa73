// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/variants.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/slam/slam.h"

namespace cvo_slam {
namespace {

void scale(int& value, double factor) { value = static_cast<int>(std::lround(value * factor)); }

struct Variant {
  std::string name;
  std::string description;
  void (*change)(TrackerOptions&);
};

const std::vector<Variant>& variants() {
  static const std::vector<Variant> table = {
      {"defaults", "the options as given", [](TrackerOptions&) {}},
      {"points-5%", "tracker.points 5 % less", [](TrackerOptions& o) { scale(o.points, 0.95); }},
      {"points+5%", "tracker.points 5 % more", [](TrackerOptions& o) { scale(o.points, 1.05); }},
      {"keyframe_points-5%", "tracker.keyframe_points 5 % less",
       [](TrackerOptions& o) { scale(o.keyframe_points, 0.95); }},
      {"keyframe_points+5%", "tracker.keyframe_points 5 % more",
       [](TrackerOptions& o) { scale(o.keyframe_points, 1.05); }},
      {"min_overlap-0.02", "tracker.keyframe.min_overlap less by 0.02",
       [](TrackerOptions& o) {
         o.keyframe.min_overlap = std::max(0.0, o.keyframe.min_overlap - 0.02);
       }},
  };
  return table;
}

const Variant& find_variant(const std::string& name) {
  const auto found = std::find_if(variants().begin(), variants().end(),
                                  [&](const Variant& variant) { return variant.name == name; });
  if (found != variants().end()) return *found;
  throw OptionError(
      fmt::format("--variants: unknown variant '{}'; {}", name, suggestion(name, variant_names())));
}

class SlamSystem final : public OdometrySystem {
 public:
  SlamSystem(const Camera& camera, const SlamOptions& options) : slam_(camera, options) {}

  std::optional<SE3> track(const RgbdFrame& frame) override {
    const FrameRecord record = slam_.track(frame);
    if (record.features_asked) ++features_asked_;
    if (record.status == TrackingStatus::kLost) return std::nullopt;
    return record.T_world_camera;
  }

  std::optional<Trajectory> finish() override {
    slam_.finish();
    return slam_.trajectory();
  }

  std::optional<std::size_t> features_asked() const override { return features_asked_; }

 private:
  Slam slam_;
  std::size_t features_asked_ = 0;
};

}  // namespace

std::vector<std::string> variant_names() {
  std::vector<std::string> names;
  for (const Variant& variant : variants()) names.push_back(variant.name);
  return names;
}

std::vector<Contestant> make_variants(const std::vector<std::string>& names,
                                      const std::string& mode, const Camera& camera,
                                      const ProgramOptions& options) {
  std::vector<Contestant> contestants;
  for (const std::string& name : names) {
    const Variant& variant = find_variant(name);
    SlamOptions changed = options.slam;
    variant.change(changed.tracker);
    changed.loops.enabled = mode == "slam";
    contestants.push_back({name, variant.description,
                           mode == "odometry" ? make_tracker_system(camera, changed.tracker)
                                              : std::make_unique<SlamSystem>(camera, changed)});
  }
  return contestants;
}

}  // namespace cvo_slam
