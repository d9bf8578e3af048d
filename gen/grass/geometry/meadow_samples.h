#pragma once

#include <optional>
#include <vector>

#include "scene/parts.h"

namespace wold::grass {

/// A system of blades that is simulated by itself and mingled with the others ([TVT] section
/// 4.1): blades of one species that age at one rate.
struct MeadowSample {
  int species = 0;                         ///< its place in scene::species_of()
  int blades = 0;                          ///< on a patch
  std::optional<scene::CurveChoice> rate;  ///< Mg_i of wd_i = Mg_i(wd); none: as the meadow does
};

/// The samples of a variant of the scene's patch, by species of its mixture (scene::mixture_of()):
/// one for each of a species' ageing rates, or one without a rate. The blades of a species are
/// shared out as evenly as possible, its first samples get one more.
std::vector<MeadowSample> samples_of(const scene::MeadowPart& meadow, int variant);

}  // namespace wold::grass
