#include "ground/haze.h"

#include <algorithm>

#include "place/each_in_view.h"

namespace wold::ground {

Haze::Haze(const light::Daylight& day, const glm::dvec3& eye_m) : day_(day), eye_m_(eye_m) {}

glm::vec3 Haze::before(const glm::vec3& radiance, const glm::dvec3& at_m) const {
  const glm::dvec3 way_m = at_m - eye_m_;
  const double distance_m = glm::length(way_m);
  if (distance_m <= 0.0) return radiance;
  const double fraction = light::haze_fraction(distance_m, day_.visual_range_m());
  return glm::mix(radiance, day_.haze_radiance(way_m / distance_m, fraction),
                  static_cast<float>(fraction));
}

bool shows_haze(const Heightfield& terrain, const glm::dvec3& eye_m, double visual_range_m) {
  constexpr double min = 0.02;
  const double size_m = terrain.size_m();
  double farthest_m = 0.0;
  for (const glm::dvec2 corner : {glm::dvec2(0, 0), {size_m, 0}, {0, size_m}, {size_m, size_m}})
    farthest_m = std::max(farthest_m, glm::distance(corner, glm::dvec2(eye_m)));
  return light::haze_fraction(farthest_m, visual_range_m) > min;
}

void veil_ground(ColourMap& ground, const Heightfield& terrain, const place::View& view,
                 const Haze& haze) {
  place::each_in_view(ground, terrain, view, [&](int i, int j, const glm::dvec3& at_m) {
    ground.at(i, j) = haze.before(ground.at(i, j), at_m);
  });
}

ColourMap veil_of_grass(const ColourMap& light, const Heightfield& terrain, const place::View& view,
                        const meadow::Meadow& meadow, const Haze& haze) {
  ColourMap veil(light.samples(), light.square(), glm::vec3(1.0F));
  place::each_in_view(veil, terrain, view, [&](int i, int j, const glm::dvec3& at_m) {
    const landscape::AggregateAppearance look = meadow.look(at_m);
    const double cover = std::max(1.0 - look.transmittance, 1e-3);
    const glm::vec3 grass = glm::vec3(look.radiance / cover) * light.at(i, j);
    constexpr float min = 1e-4F;  // a channel may be black
    veil.at(i, j) = haze.before(grass, at_m) / glm::max(grass, min);
  });
  return veil;
}

}  // namespace wold::ground
