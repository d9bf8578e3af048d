#include "expectation/cloud_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/elementary.h"

namespace wold::expectation {
namespace {

/// The part of a ray within a box: first and last distance; the last is smaller where it passes by.
std::pair<double, double> inside_m(const landscape::CloudBox& cloud, const glm::dvec3& eye_m,
                                   const glm::dvec3& direction, double end_m) {
  const glm::dvec3 low = (cloud.corner_m - eye_m) / direction;
  // Not from `low`: along an axis both are infinite.
  const glm::dvec3 high =
      (cloud.corner_m + glm::dvec3(cloud.voxels) * cloud.voxel_m - eye_m) / direction;
  const glm::dvec3 in = glm::min(low, high);
  const glm::dvec3 out = glm::max(low, high);
  return {std::max({in.x, in.y, in.z, 0.0}), std::min({out.x, out.y, out.z, end_m})};
}

/// What a volume is at a place, between its voxels' centres.
struct Medium {
  double extinction_per_m = 0.0;
  glm::dvec3 emission_per_m{0.0};
};

std::size_t index_of(const landscape::CloudBox& cloud, const glm::ivec3& voxel) {
  const glm::ivec3 at = glm::clamp(voxel, glm::ivec3(0), cloud.voxels - 1);
  return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(cloud.voxels.y) +
          static_cast<std::size_t>(at.y)) *
             static_cast<std::size_t>(cloud.voxels.x) +
         static_cast<std::size_t>(at.x);
}

Medium medium_at(const landscape::CloudBox& cloud, const glm::dvec3& place_m) {
  const glm::dvec3 at = (place_m - cloud.corner_m) / cloud.voxel_m - 0.5;
  const glm::dvec3 low = glm::floor(at), part = at - low;
  Medium medium;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 far(corner & 1, corner >> 1 & 1, corner >> 2);
    const std::size_t voxel = index_of(cloud, glm::ivec3(low) + far);
    const glm::dvec3 parts = glm::mix(1.0 - part, part, glm::dvec3(far));
    const double extinction_per_m =
        parts.x * parts.y * parts.z * double{cloud.extinction_per_m[voxel]};
    medium.extinction_per_m += extinction_per_m;
    medium.emission_per_m += extinction_per_m * glm::dvec3(cloud.radiance[voxel]);
  }
  return medium;
}

/// Goes on through one box; `weighed_m` sums distances by how much is seen there.
void pass_through(const landscape::CloudBox& cloud, const glm::dvec3& eye_m,
                  const glm::dvec3& direction, double end_m, landscape::AggregateAppearance& look,
                  double& weighed_m) {
  constexpr double nothing_left = 1e-3;
  const auto [first_m, last_m] = inside_m(cloud, eye_m, direction, end_m);
  const double step_m = cloud.voxel_m;
  for (double at_m = first_m + 0.5 * step_m; at_m < last_m && look.transmittance > nothing_left;
       at_m += step_m) {
    const Medium medium = medium_at(cloud, eye_m + at_m * direction);
    if (medium.extinction_per_m <= 0.0) continue;
    const double hidden = look.transmittance * -math::expm1(-medium.extinction_per_m * step_m);
    look.radiance += hidden / medium.extinction_per_m * medium.emission_per_m;
    look.transmittance -= hidden;
    weighed_m += hidden * at_m;
  }
}

}  // namespace

SeenBox cloud_view(std::span<const landscape::CloudBox> clouds, const glm::dvec3& eye_m,
                   const glm::dvec3& direction, double end_m) {
  SeenBox seen;
  double weighed_m = 0.0;
  for (auto cloud = clouds.rbegin(); cloud != clouds.rend(); ++cloud)  // the lowest is the nearest
    pass_through(*cloud, eye_m, direction, end_m, seen.look, weighed_m);
  const double hidden = 1.0 - seen.look.transmittance;
  if (hidden > 0.0) seen.distance_m = weighed_m / hidden;
  return seen;
}

}  // namespace wold::expectation
