#include "grass/texel/baking.h"

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <utility>

#include "core/elementary.h"
#include "core/parallel.h"
#include "grass/optics/scattered_light.h"
#include "grass/texel/columns.h"
#include "grass/texel/coverage.h"
#include "grass/texel/lods.h"
#include "grass/texel/voxel_set.h"

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

/// For every voxel of the texel the voxel of the volume that its centre lies in.
std::vector<std::uint32_t> places_in(const Texel& texel, const VolumeData& volume) {
  VoxelSet set(volume.shape);
  for (std::uint32_t voxel : volume.voxel) set.insert(voxel);
  set.number_members();
  const float scale = static_cast<float>(volume.shape.side) / static_cast<float>(texel.shape.side);
  std::vector<std::uint32_t> places(texel.size());
  for (std::size_t i = 0; i < texel.size(); ++i) {
    const glm::vec3 centre = glm::vec3(texel.shape.coordinates(texel.voxel[i])) + 0.5F;
    const glm::ivec3 at(centre * scale);
    places[i] = set.place(volume.shape.linear(at.x, at.y, at.z));
  }
  return places;
}

/// Light that changes little from voxel to voxel, on a coarser level of the texel.
class CoarseLight {
 public:
  CoarseLight(const Texel& texel, const VolumeData& volume, std::vector<DiffuseLight> light)
      : places_(places_in(texel, volume)), light_(std::move(light)) {}
  const DiffuseLight& operator[](std::size_t voxel) const { return light_[places_[voxel]]; }

 private:
  std::vector<std::uint32_t> places_;
  std::vector<DiffuseLight> light_;
};

/// Bakes the light of one texel.
class Baking {
 public:
  /// `fine` is the texel with fitted extinction and `transmittances` what that was fitted to;
  /// skylight is taken from a level of `sky_side` voxels.
  Baking(const Texel& texel, const VolumeData& fine, const Transmittances& transmittances,
         const Lighting& lighting, const FibreLook& look, int sky_side)
      : texel_(texel),
        fine_(fine),
        transmittances_(transmittances),
        lighting_(lighting),
        look_(look),
        sky_volume_(sky_side < fine.shape.side ? coarser(fine, sky_side) : fine),
        sky_through_(sky_transmittances(sky_volume_, look)) {}

  /// Source radiance per voxel of the texel as it stands turned by `turn` quarter-turns.
  std::vector<glm::vec3> emission(int turn) const {
    const Lighting lighting = turned(lighting_, turn);
    const TurnedLight light(lighting, /*turn=*/0);
    const std::vector<float> sunlit = sunlit_fractions(fine_, lighting, look_, /*turn=*/0);
    const CoarseLight sky(texel_, sky_volume_, skylight(sky_through_, lighting));
    const CoarseLight scattered = scattered_of(lighting, light, sunlit);
    std::vector<glm::vec3> emission(texel_.size());
    for (std::size_t v = 0; v < texel_.size(); ++v) {
      DiffuseLight diffuse = sky[v];
      diffuse.add(scattered[v]);
      emission[v] = source_radiance(fibre(v), light, sunlit[v], diffuse, look_.specular_exponent);
    }
    return emission;
  }

 private:
  Fibre fibre(std::size_t v) const {
    return {texel_.tangent[v], texel_.albedo[v], texel_.transmittance[v], texel_.specular[v]};
  }

  /// `sunlit`: fraction of the sun that reaches each voxel of the texel.
  CoarseLight scattered_of(const Lighting& lighting, const TurnedLight& light,
                           const std::vector<float>& sunlit) const {
    VolumeData fine{fine_.shape, fine_.voxel, fine_.density, {0, 1}, {texel_.albedo, {}}};
    fine.emission[1].reserve(texel_.size());
    for (std::size_t v = 0; v < texel_.size(); ++v)
      fine.emission[1].push_back(scattered_sunlight(fibre(v), light, sunlit[v]));
    VolumeData coarse =
        scattering_side < fine.shape.side ? coarser(fine, scattering_side) : std::move(fine);
    const glm::vec3 on_ground =
        light.sun_irradiance *
        static_cast<float>(light.sun.z * mean_transmittance(fine_, light.sun));
    coarse.density = fitted_density(coarse.shape, coarse.voxel, coarse.density, transmittances_);
    const Scatterer matter{coarse.shape, coarse.voxel, coarse.density, coarse.emission[0],
                           coarse.emission[1]};
    return {texel_, coarse,
            scattered_light(matter, {lighting.ground_albedo, on_ground}, lighting).on_matter};
  }

  static double mean_transmittance(const VolumeData& volume, const glm::dvec3& direction) {
    const std::vector<float> depths =
        optical_depths(VoxelRows(volume.shape, volume.voxel), volume.density, direction);
    double sum = 0.0;
    for (const float depth : depths) sum += double{math::exp(-depth)};
    return sum / static_cast<double>(depths.size());
  }

  const Texel& texel_;
  const VolumeData& fine_;
  const Transmittances& transmittances_;
  const Lighting& lighting_;
  const FibreLook& look_;
  VolumeData sky_volume_;
  std::vector<std::vector<float>> sky_through_;
};

}  // namespace

std::vector<VolumeData> bake_lods(const Texel& texel, std::span<const PointDynamics> samples,
                                  const Lighting& lighting, const FibreLook& look,
                                  std::span<const int> sides, const std::vector<int>& turns) {
  VolumeData mean{texel.shape, texel.voxel, texel.density, {}, {}};
  VolumeData fine = mean;
  fine.density = fitted_density(texel.shape, texel.voxel, texel.density,
                                blade_transmittances(samples, texel.shape.patch_m()));
  const Transmittances wanted = transmittances(VoxelRows(fine.shape, fine.voxel), fine.density);
  const Baking baking(texel, fine, wanted, lighting, look, sides[sides.size() > 1 ? 1 : 0]);
  std::vector<std::vector<glm::vec3>> emission(turns.size());
  parallel_for(turns.size(), [&](std::size_t i) { emission[i] = baking.emission(turns[i]); });
  fine.turns = turns;
  fine.emission = std::move(emission);
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

std::vector<glm::vec3> bake_emission(const Texel& texel, const std::vector<float>& density,
                                     const Lighting& lighting, const FibreLook& look, int turn) {
  const VolumeData volume{texel.shape, texel.voxel, density, {}, {}};
  const Transmittances shown = transmittances(VoxelRows(volume.shape, volume.voxel), density);
  return Baking(texel, volume, shown, lighting, look, texel.shape.side).emission(turn);
}

}  // namespace wold::grass
