#include "expectation/blades_appearance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold::expectation {
namespace {

double highest_m(const Tubes& tubes) {
  double highest = 1e-3;
  for (const glm::vec3& vertex : tubes.vertices_m) highest = std::max(highest, double{vertex.z});
  return highest;
}

}  // namespace

BladesAppearance::BladesAppearance(const Tubes& tubes, double ground_m2)
    : ground_m2_(ground_m2), slice_m_(highest_m(tubes) / slices) {
  const auto corners = static_cast<std::size_t>(tubes.corners);
  const auto rings = static_cast<std::size_t>(tubes.rings);
  for (std::size_t ring = 0; ring + 1 < tubes.rings_of_all(); ++ring) {
    if ((ring + 1) % rings == 0) continue;  // the next one is another tube's
    const glm::dvec3 radiance(0.5F * (tubes.radiance[ring] + tubes.radiance[ring + 1]));
    const auto corner = [&](std::size_t of_ring, std::size_t number) {
      return glm::dvec3(tubes.vertices_m[of_ring * corners + number % corners]);
    };
    for (std::size_t c = 0; c < corners; ++c)
      add_quad({corner(ring, c), corner(ring, c + 1), corner(ring + 1, c + 1), corner(ring + 1, c)},
               radiance);
  }
  for (Slice& slice : slices_)
    if (const double area = slice.upright_m2 + slice.level_m2; area > 0.0) slice.radiance /= area;
}

void BladesAppearance::add_quad(const std::array<glm::dvec3, 4>& corners_m,
                                const glm::dvec3& radiance) {
  const glm::dvec3 area_m2 =
      0.5 * glm::cross(corners_m[2] - corners_m[0], corners_m[3] - corners_m[1]);
  const double height_m =
      0.25 * (corners_m[0].z + corners_m[1].z + corners_m[2].z + corners_m[3].z);
  const int number = std::clamp(static_cast<int>(height_m / slice_m_), 0, slices - 1);
  Slice& slice = slices_[static_cast<std::size_t>(number)];
  const double upright_m2 = 0.5 * glm::length(glm::dvec2(area_m2));
  const double level_m2 = 0.5 * std::abs(area_m2.z);
  slice.upright_m2 += upright_m2;
  slice.level_m2 += level_m2;
  slice.radiance += (upright_m2 + level_m2) * radiance;
}

landscape::AggregateAppearance BladesAppearance::trace(const landscape::PatchRay& ray) const {
  // What is turned to all sides shows 2 / pi of itself to the side on the mean.
  const double sideways = glm::length(glm::dvec2(ray.direction)) * 2.0 / std::numbers::pi;
  const double down = std::abs(ray.direction.z);
  landscape::AggregateAppearance look;
  for (int i = slices - 1; i >= 0; --i) {
    const double low_m = std::max(i * slice_m_, ray.floor_m);
    const double high_m = std::min((i + 1) * slice_m_, ray.top_m);
    if (high_m <= low_m) continue;
    const Slice& slice = slices_[static_cast<std::size_t>(i)];
    const double seen_m2 = math::hypot(slice.upright_m2 * sideways, slice.level_m2 * down);
    const double depth =
        ray.thickness * (high_m - low_m) / slice_m_ * seen_m2 / (ground_m2_ * down);
    const double left = math::exp(-depth);
    look.radiance += look.transmittance * (1.0 - left) * slice.radiance;
    look.transmittance *= left;
  }
  return look;
}

}  // namespace wold::expectation
