// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// align_frames <recording>: registers two coloured point clouds, those of the frames 0 and 3.
#include <cstdio>

#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/io/dataset.h"

int main(int /*argc*/, char** argv) {
  const auto data = cvo_slam::open_dataset(argv[1]);
  const auto first = cvo_slam::select_points(data->read(0), data->camera(), 3000);
  const auto second = cvo_slam::select_points(data->read(3), data->camera(), 1500);
  const cvo_slam::RegistrationResult result = cvo_slam::align(first, second);
  const auto& t = result.T_fixed_moving.translation();
  std::printf("moved by %.4f %.4f %.4f m; overlap %.2f\n", t.x(), t.y(), t.z(), result.overlap);
}
