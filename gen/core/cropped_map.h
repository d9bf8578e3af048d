#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/ground_map.h"

namespace wold {

/// The smallest square part of a map, of its own samples, between which all of an area lies that
/// lies on the map: there it has the map's values.
template <class T, class Meaning>
GroundMap<T, Meaning> cropped(const GroundMap<T, Meaning>& map, const Square& area) {
  const double step_m = map.step_m();
  const double last = map.samples() - 1.0;
  const auto sample_of = [&](const glm::dvec2& at_m) {
    return glm::clamp((at_m - map.corner_m()) / step_m, 0.0, last);
  };
  const glm::ivec2 low(glm::floor(sample_of(area.corner_m)));
  const glm::ivec2 high(glm::ceil(sample_of(area.corner_m + area.size_m)));
  const int samples = std::max({2, high.x - low.x + 1, high.y - low.y + 1});
  if (samples >= map.samples()) return map;
  const glm::ivec2 first = glm::min(low, map.samples() - samples);
  GroundMap<T, Meaning> part(samples,
                             Square{map.place_m(first.x, first.y), (samples - 1) * step_m});
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) part.at(i, j) = map.at(first.x + i, first.y + j);
  return part;
}

}  // namespace wold
