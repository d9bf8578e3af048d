#include "landscape/light_on_grass.h"

#include <algorithm>
#include <cstddef>

#include "core/filled_map.h"

namespace wold::landscape {
namespace {

/// Whether the map covers a patch with that middle and half a patch around it.
bool covers(const ColourMap& map, const glm::dvec2& middle_m, double patch_m) {
  return 2.0 * patch_m < map.size_m() &&
         Square{map.corner_m() + patch_m, map.size_m() - 2.0 * patch_m}.contains(middle_m);
}

}  // namespace

int count_light_maps(const Landscape& landscape) {
  return 1 + static_cast<int>(landscape.light_details.size());
}

const ColourMap& light_map(const Landscape& landscape, int number) {
  return number == 0 ? landscape.light
                     : landscape.light_details.at(static_cast<std::size_t>(number - 1));
}

int light_map_at(const Landscape& landscape, const glm::dvec2& middle_m) {
  int number = count_light_maps(landscape) - 1;
  while (number > 0 && !covers(light_map(landscape, number), middle_m, landscape.patch_m)) --number;
  return number;
}

int light_map_of(const Landscape& landscape, const glm::dmat4& world_from_cell) {
  const double half_m = 0.5 * landscape.patch_m;
  return light_map_at(landscape,
                      glm::dvec2(world_from_cell * glm::dvec4(half_m, half_m, 0.0, 1.0)));
}

glm::vec3 light_on_grass(const Landscape& landscape, const glm::dvec2& at_m) {
  return light_map(landscape, light_map_at(landscape, at_m)).sample(at_m.x, at_m.y);
}

FactorMap standing_fraction(const Landscape& landscape, int number) {
  const ColourMap& light = light_map(landscape, number);
  const FactorMap& standing = landscape.extinction_factor;
  const int samples = number == 0 ? std::max(light.samples(), standing.samples()) : light.samples();
  return filled<FactorMap>({light.square(), samples},
                           [&](const glm::dvec2& at_m) { return standing.sample(at_m.x, at_m.y); });
}

ColourMap standing_light(const Landscape& landscape, int number) {
  return product(light_map(landscape, number), standing_fraction(landscape, number));
}

}  // namespace wold::landscape
