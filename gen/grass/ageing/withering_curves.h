#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "grass/mechanics/mechanics.h"
#include "scene/parts.h"

namespace wold::grass {

/// A leaf, and the scene's mean blade, at a weathering degree of its own. Contents are relative to
/// the fresh leaf.
struct WitheredState {
  double weathering = 0.0;
  double chlorophyll = 1.0;
  double carotenoid = 1.0;
  double water = 1.0;
  TissueState tissue;
  /// Between the vertical and the line from root to tip, of mean_blade(): 90 lies on the ground.
  double tip_angle_deg = 0.0;
  glm::dvec3 srgb{0.0};             ///< of the reflectance under D65, encoded, in [0, 1]
  std::vector<double> reflectance;  ///< at WitheringCurves::wavelength_nm
};

/// One of the curves that ship with the program, at the degrees of WitheringCurves::states.
struct ShippedCurve {
  std::string name;
  bool is_scenes_own = false;
  std::vector<double> values;
};

/// What a scene's [ageing] makes of a leaf, as numbers to plot ([TVT], figures 9 and 10).
struct WitheringCurves {
  std::vector<WitheredState> states;  ///< from 0 to 1 in steps of 0.01
  std::vector<double> wavelength_nm;
  std::vector<ShippedCurve> chlorophyll;  ///< by name
  std::vector<ShippedCurve> water;
};

/// Computes the curves. Throws InputError when a curve or the colour model of the scene is wrong
/// and FileError when a model is missing.
WitheringCurves withering_curves(const scene::MeadowPart& meadow);

}  // namespace wold::grass
