#include "place/ground_in_sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh_height.h"
#include "core/parallel.h"

namespace wold::place {
namespace {

/// Ways in each quarter of the compass, evenly along the side of a square that stands on its tip.
constexpr std::size_t ways_in_quarter = 1024;
constexpr std::size_t ways = 4 * ways_in_quarter;

/// Rings lie evenly between distances of powers of two, from a metre on.
constexpr std::size_t rings_in_octave = 64;

/// From the quarter of north-east on, against the clock: [0, 4).
double bearing(const glm::dvec2& way) {
  const double aside = std::abs(way.y) / (std::abs(way.x) + std::abs(way.y));
  if (way.y >= 0.0) return way.x >= 0.0 ? aside : 2.0 - aside;
  return way.x < 0.0 ? 2.0 + aside : 4.0 - aside;
}

glm::dvec2 direction(std::size_t way) {
  const double along = static_cast<double>(way % ways_in_quarter) + 0.5;
  const double aside = along / static_cast<double>(ways_in_quarter);
  const glm::dvec2 first(1.0 - aside, aside);
  switch (way / ways_in_quarter) {
    case 0:
      return glm::normalize(first);
    case 1:
      return glm::normalize(glm::dvec2(-first.y, first.x));
    case 2:
      return glm::normalize(-first);
    default:
      return glm::normalize(glm::dvec2(first.y, -first.x));
  }
}

double ring_distance_m(std::size_t ring) {
  const double in_octave =
      static_cast<double>(ring % rings_in_octave) / static_cast<double>(rings_in_octave);
  return std::ldexp(1.0 + in_octave, static_cast<int>(ring / rings_in_octave));
}

/// The last ring that is not farther; below 0 there is none.
long ring_within(double distance_m) {
  int octave = 0;
  const double in_octave = 2.0 * std::frexp(distance_m, &octave) - 1.0;
  return (octave - 1) * static_cast<long>(rings_in_octave) +
         static_cast<long>(in_octave * static_cast<double>(rings_in_octave));
}

double farthest_m(const Heightfield& terrain, const glm::dvec2& eye_m) {
  const glm::dvec2 low = terrain.corner_m(), high = low + terrain.size_m();
  return glm::length(glm::max(glm::abs(eye_m - low), glm::abs(eye_m - high)));
}

}  // namespace

GroundInSight::GroundInSight(const Heightfield& terrain, const glm::dvec3& eye_m)
    : terrain_(terrain),
      eye_m_(eye_m),
      rings_(static_cast<std::size_t>(
          std::max(0L, ring_within(farthest_m(terrain, glm::dvec2(eye_m)))) + 1)),
      highest_(ways * rings_) {
  parallel_for(ways, [&](std::size_t way) { look_along(way); });
}

void GroundInSight::look_along(std::size_t way) {
  const glm::dvec2 towards = direction(way);
  float so_far = -std::numeric_limits<float>::infinity();
  for (std::size_t ring = 0; ring < rings_; ++ring) {
    const double distance_m = ring_distance_m(ring);
    const glm::dvec2 at_m = glm::dvec2(eye_m_) + distance_m * towards;
    if (terrain_.square().contains(at_m)) {
      const double rise_m = double{mesh_height_m(terrain_, at_m)} - eye_m_.z;
      so_far = std::max(so_far, static_cast<float>(rise_m / distance_m));
    }
    highest(way, ring) = so_far;
  }
}

bool GroundInSight::may_see(const glm::dvec2& at_m, double margin_m) const {
  const glm::dvec2 away_m = at_m - glm::dvec2(eye_m_);
  const double distance_m = glm::length(away_m);
  const double nearest_m = distance_m - margin_m;
  if (nearest_m <= margin_m) return true;
  const long ring = std::min(ring_within(nearest_m), static_cast<long>(rings_) - 1);
  if (ring < 0) return true;
  const double top_m = std::max(mesh_height_m(terrain_, at_m), terrain_.sample(at_m.x, at_m.y)) +
                       margin_m - eye_m_.z;
  const auto rise = static_cast<float>(top_m / (top_m > 0.0 ? nearest_m : distance_m + margin_m));
  const long middle = static_cast<long>(bearing(away_m) * static_cast<double>(ways_in_quarter));
  const long aside =
      1 + static_cast<long>(margin_m / nearest_m * static_cast<double>(ways_in_quarter) + 1.0);
  for (long way = middle - aside; way <= middle + aside; ++way)
    if (rise >= highest(static_cast<std::size_t>(way + static_cast<long>(ways)) % ways,
                        static_cast<std::size_t>(ring)))
      return true;
  return false;
}

}  // namespace wold::place
