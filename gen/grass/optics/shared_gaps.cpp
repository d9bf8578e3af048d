#include "grass/optics/shared_gaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/elementary.h"
#include "grass/geometry/blade_places.h"
#include "grass/optics/shading.h"

namespace wold::grass {
namespace {

using std::numbers::pi;

/// A level line of sight would pass blades for ever.
constexpr double lowest_sine = 0.01;

/// Where a direction has come to at a unit's height.
glm::dvec2 slope(const glm::dvec3& direction) {
  return glm::dvec2(direction) / std::max(direction.z, lowest_sine);
}

/// Mean over azimuths of the area that places show along directions at an angle off the vertical.
double shown_m2(const std::vector<BladePlace>& places, double zenith) {
  constexpr int around = 8;
  double sum_m2 = 0.0;
  for (int i = 0; i < around; ++i) {
    const double azimuth = 2.0 * pi * i / around;
    const glm::vec3 direction(math::sin(zenith) * math::cos(azimuth),
                              math::sin(zenith) * math::sin(azimuth), math::cos(zenith));
    for (const BladePlace& place : places)
      sum_m2 += double{place.area_m2} * double{kajiya_kay_diffuse(place.fibre.tangent, direction)};
  }
  return sum_m2 / around;
}

/// The mean chord of blades, pi area / outline, over twice their mean height.
double size_over_height(const std::vector<BladePlace>& places) {
  double area_m2 = 0.0, length_m = 0.0, height_m3 = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double one_sided_m2 = 2.0 * double{places[k].area_m2};
    area_m2 += one_sided_m2;
    height_m3 += one_sided_m2 * std::max(0.0, double{places[k].position_m.z});
    if (k > 0 && places[k].blade == places[k - 1].blade)
      length_m += double{glm::distance(places[k].position_m, places[k - 1].position_m)};
  }
  const double outline_m = 2.0 * length_m;
  return pi * area_m2 / outline_m / (2.0 * height_m3 / area_m2);
}

}  // namespace

SharedGaps::SharedGaps(const BladePatch& patch, const MeadowModel& model) {
  const std::vector<BladePlace> places = blade_places(patch, model).places;
  const double ground_m2 = patch.patch_m * patch.patch_m;
  for (int i = 0; i <= steps; ++i)
    projected_[static_cast<std::size_t>(i)] = shown_m2(places, pi / 2.0 * i / steps) / ground_m2;
  for (const BladePlace& place : places)
    leaf_area_index_ += 2.0 * double{place.area_m2} / ground_m2;
  hot_spot_ = size_over_height(places);
}

double SharedGaps::depth(const glm::dvec3& direction) const {
  const double sine = std::clamp(direction.z, lowest_sine, 1.0);
  const double place = math::acos(sine) * (steps / (pi / 2.0));
  const auto below = std::min(static_cast<std::size_t>(place), projected_.size() - 2);
  return std::lerp(projected_[below], projected_[below + 1], place - static_cast<double>(below)) /
         sine;
}

double SharedGaps::passing(const glm::dvec3& direction, double growth) const {
  return math::exp(-growth * depth(direction));
}

double SharedGaps::more_sunlit(const glm::dvec3& sun, const glm::dvec3& eye, double growth) const {
  const double of_sun = depth(sun), of_eye = depth(eye);
  const double parted = glm::distance(slope(sun), slope(eye)) / hot_spot_ * 2.0 * leaf_area_index_ /
                        (of_sun + of_eye);
  const double shared = parted < 1e-6 ? 1.0 : -math::expm1(-parted) / parted;
  return passing(sun, growth) * math::expm1(growth * std::sqrt(of_sun * of_eye) * shared);
}

}  // namespace wold::grass
