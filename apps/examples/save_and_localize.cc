// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// save_and_localize <recording> <map folder>: makes a map, and locates the same frames in it.
#include <cstdio>

#include "cvo_slam/io/dataset.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/slam/slam.h"

int main(int /*argc*/, char** argv) {
  const auto data = cvo_slam::open_dataset(argv[1]);
  {
    cvo_slam::Slam slam(data->camera());
    for (std::size_t i = 0; i < data->size(); ++i) slam.track(data->read(i));
    slam.finish();
    cvo_slam::write_map(argv[2], slam.map());
  }
  // Tomorrow, in another process:
  cvo_slam::Slam slam(cvo_slam::read_map(argv[2]), {}, cvo_slam::MapUse::kLocalize);
  std::size_t localized = 0;
  for (std::size_t i = 0; i < data->size(); ++i) {
    if (slam.track(data->read(i)).localized) ++localized;
  }
  std::printf("%zu of %zu frames located\n", localized, data->size());
}
