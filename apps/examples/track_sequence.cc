// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// track_sequence <dataset> writes trajectory.txt.
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/slam/slam.h"

int main(int /*argc*/, char** argv) {
  const auto data = cvo_slam::open_dataset(argv[1]);
  cvo_slam::Slam slam(data->camera());
  for (std::size_t i = 0; i < data->size(); ++i) slam.track(data->read(i));
  slam.finish();
  cvo_slam::write_tum("trajectory.txt", slam.trajectory());
}
