#include "cloud/light_to_eye.h"

#include "cloud/between_voxels.h"
#include "core/elementary.h"
#include "core/parallel.h"

namespace wold::cloud {
namespace {

/// What is sent along a direction from between voxels.
glm::vec3 sent_along(const std::vector<LightMoments>& source, const BetweenVoxels& between,
                     const glm::vec3& way) {
  glm::vec4 sum(0.0F);
  for (std::size_t i = 0; i < 8; ++i)
    sum += between.weights[i] * source[between.voxels[i]].along(way);
  return glm::vec3(sum);
}

bool is_in(const VoxelBox& box, const glm::dvec3& place_m) {
  const glm::dvec3 at = (place_m - box.corner_m) / box.voxel_m;
  return glm::all(glm::greaterThanEqual(at, glm::dvec3(0.0))) &&
         glm::all(glm::lessThan(at, glm::dvec3(box.voxels)));
}

/// What comes to a place from behind, by steps that grow with the distance.
glm::vec3 from_behind(const ScatteringBox& scattering, const std::vector<LightMoments>& source,
                      glm::dvec3 place_m, const glm::dvec3& direction,
                      const Surroundings& surroundings) {
  constexpr double growth = 1.25;
  constexpr float nothing_left = 0.02F;
  const VoxelBox& box = scattering.box;
  const glm::vec3 way(-direction);
  double step_m = 0.5 * box.voxel_m.z;
  glm::vec3 sum(0.0F);
  float left = 1.0F;
  for (; left > nothing_left; step_m *= growth) {
    const BetweenVoxels between(box, place_m + 0.5 * step_m * direction);
    const double depth = step_m * double{between.of(scattering.extinction_per_m)};
    const auto hidden = static_cast<float>(-math::expm1(-depth)) * left;
    if (hidden > 0.0F) sum += hidden * sent_along(source, between, way);
    left -= hidden;
    place_m += step_m * direction;
    if (!is_in(box, place_m)) return surroundings ? sum + left * surroundings(direction) : sum;
  }
  return sum;
}

}  // namespace

std::vector<glm::vec3> light_to_eye(const ScatteringBox& scattering,
                                    const std::vector<LightMoments>& light, const glm::dvec3& eye_m,
                                    const Surroundings& surroundings) {
  const VoxelBox& box = scattering.box;
  const std::vector<LightMoments> source = scattered(scattering, light);
  std::vector<glm::vec3> radiance(box.count());
  parallel_for(box.count() / static_cast<std::size_t>(box.voxels.x), [&](std::size_t row) {
    const int y = static_cast<int>(row) % box.voxels.y, z = static_cast<int>(row) / box.voxels.y;
    for (int x = 0; x < box.voxels.x; ++x) {
      const glm::dvec3 centre_m = box.corner_m + (glm::dvec3(x, y, z) + 0.5) * box.voxel_m;
      radiance[box.index({x, y, z})] =
          from_behind(scattering, source, centre_m, glm::normalize(centre_m - eye_m), surroundings);
    }
  });
  return radiance;
}

}  // namespace wold::cloud
