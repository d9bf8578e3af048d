#include "ground/lake_surface.h"

#include <numbers>
#include <utility>

#include "place/each_in_view.h"

namespace wold::ground {

glm::vec3 SeenLand::at(const glm::dvec2& at_m) const {
  for (const ColourMap* map : {&on_square, &around})
    if (map->square().contains(at_m)) return map->sample(at_m.x, at_m.y);
  return far_around.sample(at_m.x, at_m.y);
}

LakeSurface::LakeSurface(const place::Site& site, const SnowyGround& ground, double time_s,
                         std::uint64_t seed, OverLakes over)
    : site_(site),
      ground_(ground),
      wind_(site.weather->at(time_s)),
      time_s_(time_s),
      seed_(seed),
      over_(std::move(over)) {}

double LakeSurface::open_water(const glm::dvec2& at_m, double step_m) const {
  const double share = site_.water->share(at_m, step_m);
  return share > 0.0 ? share * (1.0 - ground_.frozen(at_m)) : 0.0;
}

WaterSurface LakeSurface::at(const glm::dvec2& at_m, double step_m) const {
  return surface(at_m, waves(step_m));
}

void LakeSurface::add_to(ColourMap& radiance, const ColourMap& light,
                         const place::View& view) const {
  const Waves shown = waves(radiance.step_m());
  const glm::vec3 of_water = terrain::water_albedo / std::numbers::pi_v<float>;
  place::each_in_view(radiance, site_.terrain, view, [&](int i, int j, const glm::dvec3& at_m) {
    const auto share = static_cast<float>(open_water(at_m, radiance.step_m()));
    if (share <= 0.0F) return;
    const WaterSurface above = surface(at_m, shown);
    const glm::vec3 from_below = of_water * light.sample(at_m.x, at_m.y);
    radiance.at(i, j) += share * (above.radiance - above.reflectance * from_below);
  });
}

Waves LakeSurface::waves(double step_m) const { return {wind_, time_s_, seed_, step_m}; }

WaterSurface LakeSurface::surface(const glm::dvec2& at_m, const Waves& waves) const {
  const Mirrored mirrored{
      over_.where, [&](const glm::dvec2& place_m) { return over_.land.at(place_m); }, over_.sky};
  const SunOnWater sun{site_.day.sun_direction(), [&](const glm::dvec2& place_m) {
                         return over_.sunlight.sample(place_m.x, place_m.y);
                       }};
  return water_surface({at_m, site_.water->level_m(at_m)}, over_.eye_m, waves, mirrored, sun);
}

}  // namespace wold::ground
