// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/materials_internal.h"

namespace cvo_slam::synthetic {

const std::vector<std::pair<std::string, Texture>>& named_materials() {
  using namespace materials;
  static const std::vector<std::pair<std::string, Texture>> names = {
      {"parquet", parquet()},
      {"oak", oak()},
      {"walnut", walnut()},
      {"white_paint", white_paint()},
      {"dark_plastic", dark_plastic()},
      {"metal", metal()},
      {"brickwork", brickwork()},
      {"wallpaper", wallpaper()},
      {"rug", rug()},
      {"blanket", blanket()},
      {"linen", linen()},
      {"upholstery", upholstery()},
      {"cardboard", cardboard()},
      {"paper", paper()},
      {"screen", screen()},
      {"keyboard", keyboard()},
      {"poster", poster()},
      {"view", view()},
      {"carpet_tiles", carpet_tiles()},
      {"ceiling_tiles", ceiling_tiles()},
      {"kitchen_tiles", kitchen_tiles()},
      {"handwriting", handwriting()},
      {"white_board", white_board()},
      {"rough_paint", rough_paint()},
      {"carton", carton()},
      {"document", document()},
      {"keys", keys()},
      {"beech", beech()},
      {"leaves", leaves()},
      {"ceramic", ceramic()},
      {"lamp", lamp()},
      {"posters", posters()},
      {"plain", plain()},
  };
  return names;
}

const std::vector<std::pair<std::string, Pattern>>& pattern_names() {
  static const std::vector<std::pair<std::string, Pattern>> names = {
      {"plaster", Pattern::kPlaster},     {"wood", Pattern::kWood},
      {"bricks", Pattern::kBricks},       {"tiles", Pattern::kTiles},
      {"stripes", Pattern::kStripes},     {"plaid", Pattern::kPlaid},
      {"carpet", Pattern::kCarpet},       {"text", Pattern::kText},
      {"poster", Pattern::kPoster},       {"spine", Pattern::kSpine},
      {"landscape", Pattern::kLandscape}, {"collage", Pattern::kCollage},
  };
  return names;
}

}  // namespace cvo_slam::synthetic
