#include "landscape/site.h"

#include <cmath>
#include <utility>

#include "landscape/growth.h"
#include "scene/winter.h"
#include "terrain/ground.h"
#include "terrain/lighting.h"

namespace wold::landscape {

Snow::Snow(const scene::Scene& scene, const Heightfield& terrain)
    : weather(scene),
      pictures(scene.seed),
      ground(scene, terrain, [made = weather](double time_s) { return made.at(time_s); }) {}

Site make_site(const scene::Scene& scene) {
  Heightfield terrain = terrain::make_ground(scene.terrain, scene.seed);
  FactorMap growth = growth_map(scene, terrain);
  const light::Daylight day(scene.sun, scene.sky);
  terrain::GroundLight light = terrain::ground_light(terrain, day);
  ColourMap reflectance =
      terrain::ground_reflectance(terrain, day.sun_direction(), scene.terrain, scene.seed, growth,
                                  canopy_transmittance(scene.grass));
  std::optional<cloud::Clouds> clouds;
  if (!scene.clouds.empty()) clouds.emplace(scene, cloud::Clouds::usual_pixel_m(scene));
  std::shared_ptr<const Snow> snow;
  if (scene::may_snow(scene) || scene::may_lie(scene))
    snow = std::make_shared<const Snow>(scene, terrain);
  return {std::move(terrain), std::move(growth), day, std::move(light), std::move(reflectance),
          std::move(clouds),  std::move(snow)};
}

double leaf_area_index(const scene::Grass& grass) {
  const double blade_m2 = 0.5 * grass.height_m * grass.width_m;
  return grass.blades * blade_m2 / (grass.patch_m * grass.patch_m);
}

double canopy_transmittance(const scene::Grass& grass) {
  constexpr double ross = 0.5;
  constexpr double mean_slant_cosine = 0.5;
  return std::exp(-ross * leaf_area_index(grass) / mean_slant_cosine);
}

}  // namespace wold::landscape
