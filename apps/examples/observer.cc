// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// observer <recording>: a display, say, that is told of new keyframes and of those that have moved.
#include <cstdio>
#include <map>
#include <vector>

#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/slam.h"

int main(int /*argc*/, char** argv) {
  const auto data = cvo_slam::open_dataset(argv[1]);
  cvo_slam::Slam slam(data->camera());
  std::map<std::size_t, cvo_slam::SE3> shown;  // poses of keyframes by their number
  int corrections = 0;
  const auto on_frame = [&](const cvo_slam::FrameRecord& record) {
    if (record.status == cvo_slam::TrackingStatus::kLost) return;
    if (!record.keyframe_reason.empty()) shown.try_emplace(record.index, record.T_world_camera);
  };
  const auto on_correction = [&](const std::vector<cvo_slam::Keyframe>& moved) {
    ++corrections;
    for (const auto& keyframe : moved) shown[keyframe.number] = keyframe.T_world_camera;
  };
  slam.observe({.frame = on_frame, .correction = on_correction});
  for (std::size_t i = 0; i < data->size(); ++i) slam.track(data->read(i));
  slam.finish();
  std::printf("%zu keyframes, %d corrections\n", shown.size(), corrections);
}
