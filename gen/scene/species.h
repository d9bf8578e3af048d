#pragma once

#include <vector>

#include "scene/parts.h"

/// What a meadow consists of, whether the scene gives [[species]] or [grass] and [ageing] alone.
namespace wold::scene {

/// The meadow's species: those of [[species]], or the only one that [grass], [ageing] and [fur]
/// describe. One at least.
std::vector<Species> species_of(const MeadowPart& meadow);

/// Whether a species says where it grows. Any other grows wherever [growth] lets grass grow.
bool has_habitat(const Species& species);
/// How many species of a scene may say so.
inline constexpr int max_with_habitat = 4;

/// What a patch may be made of: some of the meadow's species, as places in species_of(), ascending.
using Mixture = std::vector<int>;

/// Every mixture that patches may have. The first is of all species. In mixture k those with a
/// habitat are missing whose bit is set in k, counted among the species with a habitat; none is
/// empty. A meadow whose species have no habitat has the first alone.
std::vector<Mixture> mixtures_of(const MeadowPart& meadow);

/// How many patches there may be: grass.variants of each mixture. A patch, too, is called a
/// variant, from 0 to below this: those of the first mixture come first.
int patch_count(const MeadowPart& meadow);
/// The number of a patch's mixture, and the patch of a mixture that is its `variant`-th, in
/// [0, grass.variants).
int mixture_number(const MeadowPart& meadow, int patch);
int patch_number(const MeadowPart& meadow, int mixture, int variant);
/// The mixture of a patch.
Mixture mixture_of(const MeadowPart& meadow, int patch);

/// Whether shrubs are among a mixture that have a habitat, so that they do not stand everywhere.
bool has_placed_shrubs(const MeadowPart& meadow, int mixture);
/// The number of a mixture without those: of what grows around them. It is the same mixture where
/// there are none, or nothing but them.
int without_shrubs(const MeadowPart& meadow, int mixture);

/// Blades of a patch by species, in the order of species_of(). Those that stand in the ground are
/// grass.blades in proportion to the shares, each rounded so that the sum is exact, and one at
/// least where there are enough. A shrub's stand on its twigs, over the grass: as many times
/// grass.blades as its share, one at least.
std::vector<int> blades_of(const MeadowPart& meadow);
/// The same of a patch that is of a mixture, in the order of that.
std::vector<int> blades_of(const MeadowPart& meadow, const Mixture& mixture);

/// Whether the blades of a species are leaves on a shrub's twigs, not rooted in the ground.
bool is_shrub(const Species& species);
/// Whether the blades of a species are stalks of flowers.
bool flowers(const Species& species);

/// What is drawn of a patch: blades, petals and the discs amid them.
long drawn_of(const MeadowPart& meadow, int patch);
/// Of the patch that has most of them.
long max_drawn(const MeadowPart& meadow);

/// Whether a species is hair, whose clumps are combed one way, not blades of grass (scene::Fur).
bool is_hair(const Physiology& physiology);
/// Whether any species of the meadow is hair.
bool has_hair(const Scene& scene);

/// The meadow's patch with blades that stand in the ground, as high and as wide as plants stand and
/// blades are in the mean over all of the meadow's species, shrubs by the ground that they cover:
/// for what asks how the meadow is from afar, not what grows in it.
Grass mean_grass(const MeadowPart& meadow);

/// How high a plant stands before it droops, metres: its crown and a blade of mean length.
double standing_m(const Plant& plant);
/// The highest that it may stand: its crown and a blade that is longer than the mean by as many
/// standard deviations as lengths are cut at.
double max_standing_m(const Plant& plant);

/// Which part of the blades' area of a patch of a mixture stands in the ground, where the wind
/// combs it, not on the twigs of shrubs.
double rooted_fraction(const MeadowPart& meadow, const Mixture& mixture);

/// Square metres of a mean blade with the petals on it, one side of each.
double blade_area_m2(const Species& species);

/// Square metres of blades and petals, one side of each, on a patch that is of all species, and on
/// the patch of that mixture which has most.
double blade_area_m2(const MeadowPart& meadow);
double max_blade_area_m2(const MeadowPart& meadow);

}  // namespace wold::scene
