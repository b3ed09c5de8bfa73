// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/synthetic/world.h"

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/io/synthetic/room_internal.h"

namespace cvo_slam::synthetic {

World make_world(const std::string& name, std::uint32_t seed) {
  if (name == "room") return {room_scene(seed), room_path(seed)};
  throw OptionError(
      fmt::format("scene '{}' is unknown; {}", name, suggestion(name, world_names())));
}

std::vector<std::string> world_names() { return {"room"}; }

}  // namespace cvo_slam::synthetic
