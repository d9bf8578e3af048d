#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "grass/mechanics/meadow_model.h"
#include "grass/optics/blade_light.h"
#include "grass/texel/blade_patch.h"

namespace wold::grass {

/// Places along the blades of a patch and along the snow on them: what is drawn and lit.
struct BladePlaces {
  /// Of a blade, from its root to its tip, evenly. Snow has as many on each of its two parts.
  static constexpr int per_blade = 17;

  std::vector<BladePlace> places;         ///< those of all blades, then those of the snow
  std::size_t of_blades = 0;              ///< how many are of blades
  std::vector<float> snow_half_height_m;  ///< of the snow's; its half width is BladePlace::radius_m
  /// By blade: the one on whose tip it sits, a flower's stalk, or itself.
  std::vector<std::uint32_t> carried_by;
};

BladePlaces blade_places(const BladePatch& patch, const MeadowModel& model);

}  // namespace wold::grass
