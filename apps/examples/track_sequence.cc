// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The README's example: track_sequence <dataset> writes trajectory.txt.
#include <vector>

#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/io/trajectory_files.h"

int main(int /*argc*/, char** argv) {
  const auto data = cvo_slam::open_dataset(argv[1]);
  cvo_slam::Tracker tracker(data->camera());
  std::vector<cvo_slam::FrameRecord> records;
  for (std::size_t i = 0; i < data->size(); ++i) {
    records.push_back(tracker.track(data->read(i)).record);
  }
  cvo_slam::write_tum("trajectory.txt", cvo_slam::to_trajectory(records));
}
