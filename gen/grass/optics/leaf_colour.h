#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "grass/optics/leaf_optics.h"
#include "scene/scene.h"

namespace wold::grass {

/// A leaf's colours in linear sRGB, every channel in [0, 0.99].
struct LeafShade {
  glm::vec3 reflectance;
  glm::vec3 transmittance;
  glm::vec3 albedo;  ///< of single scattering: reflectance + transmittance
};

/// What a leaf is made of when it keeps the shares `chlorophyll` and `water`, each in [0, 1], of
/// what the fresh leaf of `ageing` has.
LeafContent withered_leaf(const scene::Physiology& ageing, double chlorophyll, double water);

/// The spectrum of a leaf that keeps these shares, at the wavelengths of `optics`, by the colour
/// model that `ageing` names: "prospect" is the plate model of withered_leaf(); "paper" is [TVT]'s
/// subtraction of pigments (paper_reflectance()), which knows neither water nor
/// transmittance, so that is 0; "melanin" is that of a hair (hair_spectrum()), which has no
/// chlorophyll. Throws InputError when there is no such model.
LeafSpectrum withered_spectrum(const scene::Physiology& ageing, const LeafOptics& optics,
                               double chlorophyll, double water);

/// A leaf's colour over its own weathering degree, made once and looked up fast:
/// withered_spectrum() under D65. [TVT]'s albedo is its reflectance.
class LeafColour {
 public:
  /// Throws InputError when a curve of `ageing` is wrong and FileError when a model is missing.
  explicit LeafColour(const scene::Physiology& ageing);

  /// The shade at the leaf's own weathering degree, clamped to [0, 1].
  LeafShade operator()(double weathering) const;

 private:
  std::vector<LeafShade> table_;  ///< at equal steps from 0 to 1
};

}  // namespace wold::grass
