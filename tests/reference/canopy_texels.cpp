#include "reference/canopy_texels.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/parallel.h"
#include "grass/optics/light_under_grass.h"
#include "grass/texel/baking.h"
#include "grass/texel/columns.h"
#include "grass/texel/fibres.h"
#include "grass/texel/samples.h"
#include "grass/texel/time_varying_texel.h"
#include "light/daylight.h"

namespace wold::test {
namespace {

/// That of a film whose camera stands in the north and looks down a little.
constexpr glm::dvec3 baked_eye{0.0, 0.9659, 0.2588};

glm::vec3 soil(const scene::Scene& scene) {
  const auto& albedo = scene.terrain.ground_albedo;
  return {albedo[0], albedo[1], albedo[2]};
}

}  // namespace

CanopyTexels::CanopyTexels(double sun_deg, double weathering)
    : scene_(canopy_scene(sun_deg)),
      model_(scene_),
      lighting_(
          grass::make_lighting(light::Daylight(scene_.sun, scene_.sky), baked_eye, soil(scene_))),
      lean_light_(grass::representative_fibres(
                      grass::WitheringPatch(scene_, model_, 0).at(weathering), model_, 150),
                  lighting_, static_cast<float>(scene_.grass.specular_exponent)),
      under_grass_(grass::light_under_grass(grass::WitheringPatch(scene_, model_, 0).at(weathering),
                                            model_, lighting_)),
      shared_gaps_(grass::WitheringPatch(scene_, model_, 0).at(weathering), model_),
      variants_(static_cast<std::size_t>(scene_.grass.variants)) {
  const grass::TexelShape shape =
      grass::TimeVaryingTexel(scene_, {lighting_}, std::filesystem::temp_directory_path()).shape();
  parallel_for(variants_.size(), [&](std::size_t variant) {
    grass::Samples samples(scene_, shape, static_cast<int>(variant), model_);
    samples.advance_to(weathering);
    variants_[variant] =
        grass::bake_lods(samples.texel(), samples.all(), lighting_,
                         {static_cast<float>(scene_.grass.specular_exponent), scene_.grass.width_m},
                         scene_.grass.lods, {0});
  });
}

glm::dvec3 CanopyTexels::seen(std::size_t lod, const glm::dvec3& towards_eye) const {
  const glm::dvec3 factor(lean_light_.factor(glm::dvec2(0.0), towards_eye));
  glm::dvec3 sum(0.0);
  for (const std::vector<grass::VolumeData>& lods : variants_)
    sum += seen(lods[lod], towards_eye, factor) / static_cast<double>(variants_.size());
  return sum * std::numbers::pi;
}

glm::dvec3 CanopyTexels::seen(const grass::VolumeData& volume, const glm::dvec3& towards_eye,
                              const glm::dvec3& factor) const {
  const grass::VoxelRows voxels(volume.shape, volume.voxel);
  double uncovered = 0.0;
  const std::vector<float> depths = optical_depths(voxels, volume.density, towards_eye);
  for (const float depth : depths)
    uncovered += std::exp(-double{depth}) / static_cast<double>(depths.size());
  return factor * mean_radiance(voxels, volume.density, volume.emission.front(), towards_eye) +
         uncovered * ground(towards_eye);
}

/// Radiance of the ground that is seen under grass, as LitGround has it.
glm::dvec3 CanopyTexels::ground(const glm::dvec3& towards_eye) const {
  const glm::dvec3& sun = lighting_.sun_direction;
  const glm::dvec3 sun_irradiance = glm::dvec3(lighting_.sun_irradiance) * sun.z;
  const double more_sunlit = shared_gaps_.more_sunlit(sun, towards_eye);
  return glm::dvec3(soil(scene_)) * (glm::dvec3(under_grass_) + more_sunlit * sun_irradiance) /
         std::numbers::pi;
}

}  // namespace wold::test
