#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "core/noise.h"
#include "grass/optics/shading.h"
#include "grass/texel/blade_patch.h"
#include "place/view.h"
#include "place/withering.h"
#include "scene/scene.h"

namespace wold::meadow {

/// How the colour of a meadow differs from place to place, as rich and poor soil and other species
/// make it: by a keyed field of standard deviation 1, the richness. Leaves there hold
/// exp(ageing.pigment_spread * richness) times the scene's chlorophyll and die with
/// exp(-ageing.pigment_spread * richness) times its brown pigment. That is a modelling choice; what
/// it looks like is the leaf model's.
class PigmentSpread {
 public:
  /// `patch` is the scene's, `snow` in [0, 1] the fraction of what its blades can carry that lies
  /// on them, `lighting` what it was baked for. Throws what MeadowModel's constructor throws.
  PigmentSpread(const scene::Scene& scene, const grass::WitheringPatch& patch, double snow,
                const grass::Lighting& lighting);

  /// In [-2.5, 2.5]; of features from ageing.pigment_spread_feature, on a large terrain from a
  /// tenth of it, down to an eighth of that key, as far as a map with steps of `step_m` shows them.
  double richness(const glm::dvec2& at_m, double step_m) const;

  /// Factor on the radiance (linear sRGB) of grass of a richness at a weathering degree in [0, 1],
  /// more than 0; 1 where the richness is 0.
  glm::vec3 factor(double richness, double weathering) const;

 private:
  using ByRichness = std::array<glm::vec3, 5>;  ///< from the least to the largest

  double largest_m_;
  double rough_;                     ///< height of an octave over that of the one twice as large
  std::vector<Fbm> octaves_;         ///< from the largest feature on, each of half the size
  std::vector<ByRichness> factors_;  ///< by weathering degree, from 0 to 1
};

/// The factor on a grid in a frame (from 1), where it is in view.
ColourMap pigment_spread_map(const PigmentSpread& pigment_spread, const place::Withering& withering,
                             int frame, const Heightfield& terrain, const place::View& view,
                             const GroundGrid& grid);

}  // namespace wold::meadow
