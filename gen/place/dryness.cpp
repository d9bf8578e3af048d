#include "place/dryness.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/statistics.h"
#include "place/topography.h"
#include "terrain/relief.h"
#include "terrain/streams.h"

namespace wold::place {
namespace {

GroundMap<double> coarse(const Heightfield& terrain) {
  constexpr int max_samples = 513;
  GroundMap<double> map(std::min(terrain.samples(), max_samples), terrain.square());
  for (int j = 0; j < map.samples(); ++j)
    for (int i = 0; i < map.samples(); ++i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      map.at(i, j) = double{terrain.sample(at_m.x, at_m.y)};
    }
  return map;
}

/// To mean 0 and standard deviation 1; a map of one value to 0.
void standardise(FactorMap& map) {
  constexpr float farthest = 2.5F, least = 1e-6F;
  const auto middle = static_cast<float>(mean(map.values()));
  double variance = 0.0;
  for (float& value : map.values()) {
    value -= middle;
    variance += double{value} * value / static_cast<double>(map.values().size());
  }
  const float deviation = std::max(static_cast<float>(std::sqrt(variance)), least);
  for (float& value : map.values()) value = std::clamp(value / deviation, -farthest, farthest);
}

}  // namespace

FactorMap dryness_map(const Heightfield& terrain, const glm::dvec3& sun) {
  constexpr double least_slope = 0.01;
  constexpr double usual_sunlight = 0.25;  // deviation on mountains
  const GroundMap<double> heights_m = coarse(terrain);
  const GroundMap<double> drained = terrain::drained_samples(heights_m);
  FactorMap dryness(heights_m.samples(), heights_m.square());
  FactorMap sunlight = dryness;
  for (int j = 0; j < dryness.samples(); ++j)
    for (int i = 0; i < dryness.samples(); ++i) {
      const glm::dvec2 at_m = dryness.place_m(i, j);
      const glm::dvec2 ascent = terrain::gradient(terrain, at_m.x, at_m.y);
      const double contour_m = drained.at(i, j) * heights_m.step_m();
      dryness.at(i, j) =
          static_cast<float>(-math::log(contour_m / std::max(glm::length(ascent), least_slope)));
      sunlight.at(i, j) = static_cast<float>((sun_over_level(ascent, sun) - 1.0) / usual_sunlight);
    }
  standardise(dryness);
  for (std::size_t k = 0; k < dryness.values().size(); ++k)
    dryness.values()[k] += sunlight.values()[k];
  standardise(dryness);
  for (int pass = 0; pass < 2; ++pass) smooth(dryness);
  return dryness;
}

}  // namespace wold::place
