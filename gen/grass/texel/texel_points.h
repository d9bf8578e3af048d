#pragma once

#include <cstdint>

#include "grass/texel/points.h"

namespace wold::grass {

/// What a texel becomes when it is sampled: points, and the blades that they lie on.
struct SampledTexel {
  std::vector<Blade> blades;
  Points points;
};

/// Texel to points, [TVT]'s own way (section 2.3): a voxel gives Num = proportion * rho points,
/// rho as its optical depth, at keyed random places in it, that inherit its frame. Areas are the
/// texel's to the last one; Num below one is drawn by chance.
///
/// Blades are found as figure 6a finds them: the tangent of a point, prolonged to the ground, meets
/// it at the blade's foot (a tangent rises by 12 degrees at the least). Points whose feet are near
/// to each other (two voxels, or a 64th of the patch if that is more) and whose tangents point
/// into the same eighth of the horizon are a blade: straight, with the mean of their feet, tangents
/// and colours, as long as the farthest of them reaches and as wide as their area asks. How it
/// droops and ages is drawn as for blades that are scattered; it is fresh and straight at first,
/// so its points stand where the texel has them. One that has withered fades from the texel's own
/// colour into the model's.
///
/// Throws InputError when there would be more than twenty million points.
SampledTexel sample_texel(const Texel& texel, const scene::Grass& grass,
                          const scene::Physiology& ageing, std::uint64_t seed);

}  // namespace wold::grass
