#include "scene/cover_classes.h"

namespace wold::scene {
namespace {

/// Colours are those of broad classes of land in the visible, linear sRGB: modelling choices.
std::vector<CoverClass> esa_world_cover() {
  const std::vector<double> none;
  return {
      {10, 0.1, 0.0, {0.026, 0.042, 0.018}},   // tree cover
      {20, 0.45, 0.0, {0.065, 0.075, 0.035}},  // shrubland
      {30, 1.0, 0.0, none},                    // grassland
      {40, 0.9, 0.0, none},                    // cropland
      {50, 0.25, 0.0, {0.16, 0.155, 0.15}},    // built-up
      {60, 0.06, 0.0, none},                   // bare and sparse vegetation
      {70, 0.0, 0.0, {0.6, 0.62, 0.66}},       // snow and ice
      {80, 0.0, 1.0, {0.010, 0.026, 0.032}},   // permanent water bodies
      {90, 0.9, 0.0, {0.05, 0.05, 0.03}},      // herbaceous wetland
      {95, 0.0, 0.0, {0.026, 0.042, 0.018}},   // mangroves
      {100, 0.3, 0.0, {0.1, 0.095, 0.06}},     // moss and lichen
  };
}

}  // namespace

std::vector<CoverClass> cover_classes_of(const Scene& scene) {
  return scene.cover_classes.empty() ? esa_world_cover() : scene.cover_classes;
}

}  // namespace wold::scene
