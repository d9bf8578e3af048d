#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "grass/mechanics/dynamics.h"
#include "grass/optics/shading.h"
#include "grass/texel/columns.h"
#include "grass/texel/points.h"

/// A meadow that is made in milliseconds, and shorthands for the tests of gen/grass.
namespace wold::grass::test {

inline constexpr double pi = std::numbers::pi;
inline constexpr double degree = pi / 180.0;

/// A quarter of the default patch, as dense as it.
inline scene::Scene small_scene() {
  scene::Scene scene;
  scene.grass.patch_m = 0.25;
  scene.grass.blades = 100;
  scene.grass.height_m = 0.2;
  scene.grass.variants = 2;
  scene.grass.lods = {62, 30};
  scene.grass.key_frames = {0.0, 0.5, 1.0};
  scene.ageing.fresh_spread = 0.0;  // every blade is fresh at the beginning
  scene.ageing.litter = 0.0;
  return scene;
}

inline TexelShape small_shape(int side = 62) {
  return {side, side * 8 / 5, small_scene().grass.patch_m / side};
}

inline std::vector<Blade> small_blades() {
  const scene::Scene scene = small_scene();
  return scatter_blades(scene.grass, scene.ageing, {scene.grass.patch_m, scene.grass.blades, 7, 0});
}

inline Blade straight_blade() {
  Blade blade;
  blade.root_m = {0.1F, 0.12F};
  blade.heading = {0.6F, 0.8F};
  blade.lean = static_cast<float>(20.0 * degree);
  blade.length_m = 0.18F;
  blade.radius_m = 0.003F;
  return blade;
}

/// Sun from one side, eye from another, a sky that is bluer on top.
/// The sky is brighter in each quarter than in the one before.
inline Lighting slanting_light() {
  std::vector<glm::vec3> sky;
  for (const glm::vec3 ring : {glm::vec3(0.10F, 0.12F, 0.14F), glm::vec3(0.07F, 0.10F, 0.15F),
                               glm::vec3(0.05F, 0.09F, 0.16F)})
    for (const float quarter : {0.7F, 0.9F, 1.1F, 1.3F}) sky.push_back(quarter * ring);
  return {
      direction_at(40.0 * degree, 0.7), {1.2F, 1.1F, 0.9F}, sky, direction_at(8.0 * degree, -2.0)};
}

inline double sum(const std::vector<float>& values) {
  double total = 0.0;
  for (float value : values) total += double{value};
  return total;
}

}  // namespace wold::grass::test
