// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The materials that the built-in worlds share, and the names of materials and patterns in world
// files.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cvo_slam/synthetic/texture.h"

namespace cvo_slam::synthetic {

/// Returns the materials below by name.
[[nodiscard]] const std::vector<std::pair<std::string, Texture>>& named_materials();

[[nodiscard]] const std::vector<std::pair<std::string, Pattern>>& pattern_names();

}  // namespace cvo_slam::synthetic

namespace cvo_slam::synthetic::materials {

inline Texture parquet() {
  return {Pattern::kWood, {0.70, 0.52, 0.34}, {0.36, 0.22, 0.12}, 0.14, 0.5};
}
inline Texture oak() { return {Pattern::kWood, {0.80, 0.62, 0.40}, {0.45, 0.29, 0.16}, 0.30, 0.4}; }
inline Texture walnut() {
  return {Pattern::kWood, {0.50, 0.33, 0.22}, {0.18, 0.10, 0.07}, 0.25, 0.4};
}
inline Texture white_paint() {
  return {Pattern::kPlaster, {0.84, 0.83, 0.80}, {0.5, 0.5, 0.5}, 0.1, 0.28};
}
inline Texture dark_plastic() {
  return {Pattern::kPlaster, {0.13, 0.13, 0.14}, {0.2, 0.2, 0.2}, 0.1, 0.5};
}
inline Texture metal() {
  return {Pattern::kPlaster, {0.62, 0.64, 0.66}, {0.3, 0.3, 0.3}, 0.1, 0.3};
}
inline Texture brickwork() {
  return {Pattern::kBricks, {0.62, 0.31, 0.22}, {0.74, 0.71, 0.66}, 0.24, 0.6};
}
inline Texture wallpaper() {
  return {Pattern::kStripes, {0.82, 0.80, 0.68}, {0.52, 0.63, 0.55}, 0.16, 0.3};
}
inline Texture rug() {
  return {Pattern::kCarpet, {0.55, 0.13, 0.12}, {0.86, 0.74, 0.50}, 0.10, 0.5};
}
inline Texture blanket() {
  return {Pattern::kPlaid, {0.20, 0.30, 0.55}, {0.90, 0.86, 0.74}, 0.16, 0.5};
}
inline Texture linen() {
  return {Pattern::kPlaid, {0.92, 0.91, 0.88}, {0.62, 0.66, 0.78}, 0.08, 0.15};
}
inline Texture upholstery() {
  return {Pattern::kPlaid, {0.36, 0.45, 0.33}, {0.22, 0.28, 0.20}, 0.06, 0.5};
}
inline Texture cardboard() {
  return {Pattern::kText, {0.70, 0.54, 0.36}, {0.30, 0.20, 0.12}, 0.07, 0.4};
}
inline Texture paper() { return {Pattern::kText, {0.95, 0.95, 0.93}, {0.1, 0.1, 0.12}, 0.02, 0.1}; }
inline Texture screen() {
  return {Pattern::kText, {0.07, 0.09, 0.14}, {0.65, 0.85, 0.75}, 0.025, 0.1};
}
inline Texture keyboard() {
  return {Pattern::kTiles, {0.16, 0.16, 0.17}, {0.30, 0.30, 0.32}, 0.02, 0.3};
}
inline Texture poster() {
  return {Pattern::kPoster, {0.94, 0.93, 0.90}, {0.12, 0.10, 0.16}, 0.1, 0.15};
}
inline Texture view() {
  return {Pattern::kLandscape, {0.42, 0.62, 0.90}, {0.24, 0.38, 0.16}, 0.1, 0.1};
}
inline Texture carpet_tiles() {
  return {Pattern::kTiles, {0.34, 0.36, 0.40}, {0.30, 0.32, 0.37}, 0.50, 0.75};
}
inline Texture ceiling_tiles() {
  return {Pattern::kTiles, {0.80, 0.80, 0.78}, {0.78, 0.78, 0.77}, 0.60, 0.35};
}
inline Texture kitchen_tiles() {
  return {Pattern::kTiles, {0.80, 0.84, 0.84}, {0.62, 0.72, 0.76}, 0.15, 0.2};
}
inline Texture handwriting() {
  return {Pattern::kText, {0.93, 0.94, 0.94}, {0.12, 0.16, 0.45}, 0.055, 0.03};
}
inline Texture white_board() {
  return {Pattern::kPlaster, {0.93, 0.94, 0.94}, {0.5, 0.5, 0.5}, 0.1, 0.03};
}
inline Texture rough_paint() {
  return {Pattern::kPlaster, {0.80, 0.79, 0.75}, {0.5, 0.5, 0.5}, 0.03, 0.12};
}
inline Texture carton() {
  return {Pattern::kText, {0.68, 0.53, 0.37}, {0.55, 0.41, 0.27}, 0.09, 0.25};
}
inline Texture document() {
  return {Pattern::kText, {0.88, 0.88, 0.86}, {0.32, 0.32, 0.35}, 0.014, 0.06};
}
inline Texture keys() {
  return {Pattern::kTiles, {0.24, 0.24, 0.25}, {0.21, 0.21, 0.22}, 0.019, 0.2};
}
inline Texture beech() {
  return {Pattern::kWood, {0.84, 0.72, 0.54}, {0.66, 0.52, 0.36}, 0.45, 0.25};
}
inline Texture leaves() {
  return {Pattern::kPlaster, {0.16, 0.38, 0.13}, {0.1, 0.2, 0.1}, 0.1, 0.95};
}
inline Texture ceramic() {
  return {Pattern::kPlaster, {0.85, 0.85, 0.82}, {0.2, 0.2, 0.2}, 0.05, 0.15};
}
inline Texture lamp() { return {Pattern::kPlaster, {1.0, 1.0, 0.97}, {1, 1, 1}, 0.1, 0.02}; }
inline Texture posters() {
  return {Pattern::kCollage, {0.94, 0.93, 0.90}, {0.12, 0.10, 0.16}, 0.45, 0.35};
}
/// A painted wall whose contrast under the worlds' light is two grey levels of 255.
inline Texture plain() {
  return {Pattern::kPlaster, {0.66, 0.66, 0.64}, {0.5, 0.5, 0.5}, 0.1, 0.021};
}
/// Returns the material of an upright board.
inline Texture upright(Texture texture) {
  texture.quarter_turn = true;
  return texture;
}

}  // namespace cvo_slam::synthetic::materials
