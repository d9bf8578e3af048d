#include "cloud/ordinates.h"

#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold::cloud {
namespace {

/// Index of the ordinate that a unit vector is nearest to.
std::size_t nearest_ordinate(const glm::dvec3& direction) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < ordinate_count; ++i)
    if (glm::dot(ordinates()[i], direction) > glm::dot(ordinates()[nearest], direction))
      nearest = i;
  return nearest;
}

}  // namespace

const std::array<glm::dvec3, ordinate_count>& ordinates() {
  static const std::array<glm::dvec3, ordinate_count> all = [] {
    constexpr double low = 0.3500211745815407;
    const double high = std::sqrt(1.0 - 2.0 * low * low);
    std::array<glm::dvec3, ordinate_count> made;
    for (int i = 0; i < ordinate_count; ++i) {
      const int octant = i % 8;
      glm::dvec3 direction(low);
      direction[i / 8] = high;
      made[static_cast<std::size_t>(i)] =
          direction * (2.0 * glm::dvec3(octant & 1, octant >> 1 & 1, octant >> 2) - 1.0);
    }
    return made;
  }();
  return all;
}

ArrivingRadiance arriving_radiance(
    const std::function<glm::vec3(const glm::dvec3& direction)>& radiance_from) {
  constexpr int rings = 48, azimuths = 96;  // rings of equal height: each direction counts alike
  std::array<glm::dvec4, ordinate_count> sums{};
  for (int r = 0; r < rings; ++r)
    for (int a = 0; a < azimuths; ++a) {
      const double z = 2.0 * (r + 0.5) / rings - 1.0, across = std::sqrt(1.0 - z * z);
      const double azimuth = 2.0 * std::numbers::pi * (a + 0.5) / azimuths;
      const glm::dvec3 from(across * math::sin(azimuth), across * math::cos(azimuth), z);
      sums[nearest_ordinate(-from)] += glm::dvec4(glm::dvec3(radiance_from(from)), 1.0);
    }
  ArrivingRadiance radiance{};
  for (std::size_t i = 0; i < sums.size(); ++i)
    radiance[i] = glm::vec3(glm::dvec3(sums[i]) / sums[i].w);
  return radiance;
}

}  // namespace wold::cloud
