#include "place/topography.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/elementary.h"
#include "terrain/relief.h"

namespace wold::place {
namespace {

/// Each value's rank among all, over their number; equal values have the mean of their ranks.
FactorMap ranks(FactorMap map) {
  std::vector<float>& values = map.values();
  std::vector<float> sorted = values;
  std::ranges::sort(sorted);
  const auto count = static_cast<float>(sorted.size());
  for (float& value : values) {
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), value);
    const auto below = static_cast<float>(first - sorted.begin());
    const auto not_above = static_cast<float>(last - sorted.begin());
    value = 0.5F * (below + not_above) / count;
  }
  return map;
}

/// What is less than that is rounding, not relief.
FactorMap in_millimetres(FactorMap map_m) {
  for (float& value : map_m.values()) value = std::round(1000.0F * value);
  return map_m;
}

}  // namespace

Heightfield coarsened(const Heightfield& terrain) {
  constexpr int max_samples = 129;
  Heightfield coarse(std::min(terrain.samples(), max_samples), terrain.square());
  for (int j = 0; j < coarse.samples(); ++j)
    for (int i = 0; i < coarse.samples(); ++i) {
      const glm::dvec2 at_m = coarse.place_m(i, j);
      coarse.at(i, j) = terrain.sample(at_m.x, at_m.y);
    }
  return coarse;
}

FactorMap depth_below_surroundings_m(const Heightfield& terrain) {
  Heightfield around = terrain;
  const int radius = terrain.samples() / 16;
  for (int pass = 0; pass < 2 * radius * radius; ++pass) smooth(around);
  FactorMap depth_m(terrain.samples(), terrain.square());
  for (std::size_t k = 0; k < depth_m.values().size(); ++k)
    depth_m.values()[k] = around.values()[k] - terrain.values()[k];
  return depth_m;
}

FactorMap hollows(const Heightfield& terrain) {
  FactorMap depth = depth_below_surroundings_m(terrain);
  for (float& value : depth.values()) value = std::max(0.0F, value);
  const float deepest = *std::ranges::max_element(depth.values());
  if (deepest > 0.0F)
    for (float& value : depth.values()) value /= deepest;
  return depth;
}

glm::dvec3 equinox_sun(double latitude_deg) {
  const double latitude = glm::radians(latitude_deg);
  return {0.0, -math::sin(latitude), math::cos(latitude)};
}

double sun_over_level(const glm::dvec2& gradient, const glm::dvec3& sun) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-gradient, 1.0));
  constexpr double min_level = 0.2;
  return std::clamp(glm::dot(normal, sun) / std::max(sun.z, min_level), 0.0, 2.0);
}

Topography::Topography(const Heightfield& terrain, double latitude_deg)
    : terrain_(coarsened(terrain)),
      sun_(equinox_sun(latitude_deg)),
      wetness_(ranks(in_millimetres(depth_below_surroundings_m(terrain_)))) {}

double Topography::wetness(const glm::dvec2& at_m) const {
  return double{wetness_.sample(at_m.x, at_m.y)};
}

double Topography::sun(const glm::dvec2& at_m) const {
  return sun_over_level(terrain::gradient(terrain_, at_m.x, at_m.y), sun_);
}

}  // namespace wold::place
