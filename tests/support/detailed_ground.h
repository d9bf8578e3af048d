#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "landscape/landscape.h"

namespace wold::test {

/// Makes a landscape one of an even ground of 64 m, 2 m per pixel, of radiance 0.05, that has finer
/// pictures: of the middle 16 m with twice that, and in it, from (30, 28) to (38, 36), a chequered
/// one of 0.2 and black, a sample of 0.25 m each. The camera looks down at it.
inline void make_detailed_ground(landscape::Landscape& scene) {
  scene.cells.clear();
  scene.blade_cells.clear();
  scene.terrain = Heightfield(3, 64.0);
  scene.ground = ColourMap(33, 64.0, glm::vec3(0.05F));
  landscape::GroundDetail even{ColourMap(33, 16.0, glm::vec3(0.1F)), {24.0, 24.0}};
  landscape::GroundDetail chequered{ColourMap(33, 8.0), {30.0, 28.0}};
  for (int j = 0; j < 33; ++j)
    for (int i = 0; i < 33; ++i) chequered.map.at(i, j) = glm::vec3((i + j) % 2 == 0 ? 0.2F : 0.0F);
  scene.ground_details = {even, chequered};
  scene.camera = {{34.0, 31.9, 40.0}, {34.0, 32.0, 0.0}, 30.0};
  scene.width_px = 640;
  scene.height_px = 640;
  scene.samples = 4;
}

struct PlaceOfGround {
  glm::dvec3 place_m;
  double radiance;
  double tolerance;  ///< wide where half a pixel aside it is another
};

/// Places on make_detailed_ground()'s ground and what is seen there: outside, half way into a soft
/// border, and on both colours of the chequer.
inline std::vector<PlaceOfGround> places_of_detailed_ground() {
  return {{{23.5, 32.0, 0.0}, 0.05, 0.003},   // the coarsest, beside the finer
          {{26.0, 30.5, 0.0}, 0.075, 0.003},  // half way into the soft border of 4 m
          {{29.5, 34.0, 0.0}, 0.1, 0.003},    // the finer, beside the finest
          {{33.0, 32.0, 0.0}, 0.2, 0.03},     // samples 12 and 16 of the finest
          {{33.25, 32.0, 0.0}, 0.0, 0.03},    // its neighbour
          {{33.125, 32.0, 0.0}, 0.1, 0.03},   // between the two
          {{35.0, 33.25, 0.0}, 0.0, 0.03}};
}

}  // namespace wold::test
