#include "grass/texel/baking.h"

#include "core/parallel.h"
#include "grass/texel/columns.h"
#include "grass/texel/coverage.h"
#include "grass/texel/lods.h"

namespace wold::grass {
namespace {

/// What opaque blades let through, from the same directions as Transmittances.
Transmittances blade_transmittances(std::span<const PointDynamics> samples, double patch_m) {
  std::vector<Blade> blades;
  std::vector<BladePose> poses;
  for (const PointDynamics& sample : samples) {
    blades.insert(blades.end(), sample.blades().begin(), sample.blades().end());
    poses.insert(poses.end(), sample.poses().begin(), sample.poses().end());
  }
  Transmittances result;
  for (std::size_t i = 0; i < result.value.size(); ++i)
    result.value[i] = blade_transmittance(
        blades, poses, patch_m, transmittance_directions(Transmittances::elevations_deg[i]));
  return result;
}

}  // namespace

std::vector<VolumeData> bake_lods(const Texel& texel, std::span<const PointDynamics> samples,
                                  const Lighting& lighting, const FibreLook& look,
                                  std::span<const int> sides, const std::vector<int>& turns) {
  VolumeData mean{texel.shape, texel.voxel, texel.density, {}, {}};
  VolumeData fine = mean;
  fine.density = fitted_density(texel.shape, texel.voxel, texel.density,
                                blade_transmittances(samples, texel.shape.patch_m()));
  const Transmittances wanted = transmittances(VoxelRows(fine.shape, fine.voxel), fine.density);
  const std::vector<glm::vec3> sky =
      skylight(texel, sides.size() > 1 ? coarser(fine, sides[1]) : fine, lighting, look);
  fine.turns = turns;
  fine.emission.resize(turns.size());
  parallel_for(turns.size(), [&](std::size_t i) {
    fine.emission[i] = bake_emission(texel, fine.density, sky, lighting, look, turns[i]);
  });
  // Areas add up from level to level, fitted extinctions do not: reduce the former, fit each.
  mean.turns = turns;
  mean.emission = fine.emission;
  const std::vector<glm::dvec3> radiance = radiances(fine);
  std::vector<VolumeData> lods;
  lods.push_back(std::move(fine));
  for (int side : sides.subspan(1)) {
    mean = coarser(mean, side);
    VolumeData lod = without_faint(mean);
    lod.density = fitted_density(lod.shape, lod.voxel, lod.density, wanted);
    match_radiances(lod, radiance);
    lods.push_back(std::move(lod));
  }
  return lods;
}

}  // namespace wold::grass
