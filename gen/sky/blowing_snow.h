#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "landscape/landscape.h"
#include "place/site.h"
#include "scene/scene.h"

namespace wold::sky {

/// The snow that wind may lift, and what lights it.
struct SnowField {
  /// Fraction of the ground at a place, metres, from which wind can lift snow, in [0, 1].
  std::function<double(const glm::dvec2& at_m)> loose;
  FactorMap sunlit;     ///< fraction of the sun's light that reaches the ground, in [0, 1]
  double albedo = 0.8;  ///< mean of the ground around
};

/// Adds snow that blows over the ground before the landscape's camera to its volumes: fine ones
/// near the eye, and on wide terrains coarser ones beyond them, up to 150 m away. Its frame,
/// camera, terrain, daylight and sky have to be set. `field` is asked for where the wind is strong
/// enough; else nothing is added.
void add_blowing_snow(const scene::Scene& scene, const place::Site& site,
                      const std::function<SnowField()>& field, landscape::Landscape& landscape);

/// Voxels of all those volumes of a frame, about; for plans. 0 where scene::is_stormy() not.
double blowing_snow_voxels(const scene::Scene& scene);

}  // namespace wold::sky
