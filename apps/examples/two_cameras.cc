// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// two_cameras <recording> <recording>: two Slam objects, each in a thread of its own.
#include <cstdio>
#include <thread>

#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/slam.h"

namespace {

void track_recording(const char* folder, std::size_t& tracked) {
  const auto data = cvo_slam::open_dataset(folder);
  cvo_slam::Slam slam(data->camera());
  for (std::size_t i = 0; i < data->size(); ++i) slam.track(data->read(i));
  slam.finish();
  tracked = slam.trajectory().poses.size();
}

}  // namespace

int main(int /*argc*/, char** argv) {
  std::size_t first = 0;
  std::size_t second = 0;
  std::thread other([&] { track_recording(argv[2], second); });
  track_recording(argv[1], first);
  other.join();
  std::printf("%zu and %zu frames tracked\n", first, second);
}
