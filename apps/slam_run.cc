// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/slam_run.h"

namespace cvo_slam {

SlamRun run_slam(const Dataset& data, const FrameRange& range, const ProgramOptions& options,
                 const std::shared_ptr<const Vocabulary>& vocabulary, const RunControl& control) {
  Slam slam(data.camera(), options.tracker, options.slam, vocabulary);
  SlamRun result;
  result.run = run_frames(
      data, range, [&](const RgbdFrame& frame) { return slam.track(frame); },
      [&] { slam.finish(); }, control);
  result.trajectory = slam.trajectory(TrajectoryView::kFinal);
  result.graph = {slam.pose_graph(), slam.keyframes(), slam.loop_candidates(),
                  slam.graph_statistics()};
  return result;
}

}  // namespace cvo_slam
