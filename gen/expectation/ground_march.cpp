#include "expectation/ground_march.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elementary.h"
#include "core/mesh_height.h"

namespace wold::expectation {
namespace {

/// Rise over run where the terrain is steepest.
double steepest_slope(const Heightfield& terrain) {
  double steepest_m = 0.0;  // over a step
  for (int j = 0; j + 1 < terrain.samples(); ++j)
    for (int i = 0; i + 1 < terrain.samples(); ++i) {
      const float low = terrain.at(i, j), east = terrain.at(i + 1, j), north = terrain.at(i, j + 1),
                  high = terrain.at(i + 1, j + 1);
      const float east_m = std::max(std::abs(east - low), std::abs(high - north));
      const float north_m = std::max(std::abs(north - low), std::abs(high - east));
      steepest_m = std::max(steepest_m, double{math::hypot(east_m, north_m)});
    }
  return steepest_m / terrain.step_m();
}

/// A place along a ray and how high it is above the ground.
struct Place {
  double at_m;
  double gap_m;
};

/// Where the ray meets the ground between a place above it and one below, by false position: over
/// so short a way the ground is almost even.
template <class PlaceAt>
double meeting_m(Place above, Place below, const PlaceAt& place) {
  for (int i = 0; i < 3; ++i) {
    const double fraction = above.gap_m / (above.gap_m - below.gap_m);
    const Place middle = place(std::lerp(above.at_m, below.at_m, fraction));
    if (middle.gap_m > 0.0) {
      above = middle;
    } else {
      below = middle;
    }
  }
  return above.gap_m < -below.gap_m ? above.at_m : below.at_m;
}

}  // namespace

GroundMarch::GroundMarch(const Heightfield& terrain)
    : terrain_(terrain),
      steepest_(steepest_slope(terrain)),
      low_(terrain.corner_m(), *std::min_element(terrain.values().begin(), terrain.values().end())),
      high_(terrain.corner_m() + terrain.size_m(),
            *std::max_element(terrain.values().begin(), terrain.values().end())) {}

double GroundMarch::distance_m(const glm::dvec3& eye_m, const glm::dvec3& direction,
                               double above_to_m) const {
  const auto [begin, last] = inside_m(eye_m, direction);
  const double first = std::max(begin, above_to_m);
  const auto place = [&](double at_m) { return Place{at_m, gap_m(eye_m + at_m * direction)}; };
  // How much a gap can shrink along a metre of the ray.
  const double closing =
      std::clamp(steepest_ * glm::length(glm::dvec2(direction)) - direction.z, 1e-9, 2.0);
  Place above{first, 0.0};
  for (double at = first; first < last;) {
    const Place here = place(at);
    if (here.gap_m <= 0.0) return at == first ? at : meeting_m(above, here, place);
    if (at >= last) break;
    above = here;
    const double min_m = 0.3 * terrain_.step_m() + 3e-3 * at;
    at = std::min(last, at + std::max(here.gap_m / closing, min_m));
  }
  return std::numeric_limits<double>::infinity();
}

/// The part of the ray within the terrain's box.
std::pair<double, double> GroundMarch::inside_m(const glm::dvec3& eye_m,
                                                const glm::dvec3& direction) const {
  double first = 0.0;
  double last = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double low = (low_[axis] - 1e-3 - eye_m[axis]) / direction[axis];
    const double high = (high_[axis] + 1e-3 - eye_m[axis]) / direction[axis];
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  return {first, last};
}

double GroundMarch::gap_m(const glm::dvec3& at_m) const {
  return at_m.z - mesh_height_m(terrain_, glm::dvec2(at_m));
}

}  // namespace wold::expectation
