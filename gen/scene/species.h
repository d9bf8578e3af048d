#pragma once

#include <vector>

#include "scene/parts.h"

/// What a meadow consists of, whether the scene gives [[species]] or [grass] and [ageing] alone.
namespace wold::scene {

/// The meadow's species: those of [[species]], or the only one that [grass], [ageing] and [fur]
/// describe. One at least.
std::vector<Species> species_of(const MeadowPart& meadow);

/// Blades of a patch by species, in the order of species_of(): grass.blades in proportion to the
/// shares, each rounded so that the sum is exact.
std::vector<int> blades_of(const MeadowPart& meadow);

/// Whether a species is hair, whose clumps are combed one way, not blades of grass (scene::Fur).
bool is_hair(const Physiology& physiology);
/// Whether any species of the meadow is hair.
bool has_hair(const Scene& scene);

/// The meadow's patch with blades as high and as wide as the mean over all of the meadow's species:
/// for what asks how the meadow is from afar, not what grows in it.
Grass mean_grass(const MeadowPart& meadow);

/// The longest that a blade of the species is before it droops, metres: its mean and as many
/// standard deviations as lengths are cut at.
double longest_blade_m(const Plant& plant);

/// Square metres of blades on a patch of the meadow, one side of each.
double blade_area_m2(const MeadowPart& meadow);

}  // namespace wold::scene
