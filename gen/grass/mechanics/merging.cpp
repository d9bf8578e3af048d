#include "grass/mechanics/merging.h"

namespace wold::grass {
namespace {

/// Puts what a point stands for into another one of its blade and tissue.
void merge_into(Points& points, std::uint32_t to, std::uint32_t from) {
  const float fraction = points.area_m2[from] / (points.area_m2[to] + points.area_m2[from]);
  const auto mean = [&](auto& values) { values[to] += (values[from] - values[to]) * fraction; };
  mean(points.side_m);
  mean(points.across_m);
  mean(points.position_m);
  mean(points.albedo);
  mean(points.transmittance);
  mean(points.specular);
  points.rest_area_m2[to] += points.rest_area_m2[from];
  points.area_m2[to] += points.area_m2[from];
  points.rest_area_m2[from] = 0.0F;
  points.area_m2[from] = 0.0F;
}

}  // namespace

void merge_points(Points& points, std::size_t blade, float distance_m) {
  const std::uint32_t end = points.blade_begin[blade + 1];
  for (std::uint32_t i = points.blade_begin[blade]; i < end; ++i) {
    if (points.area_m2[i] == 0.0F) continue;
    for (std::uint32_t j = i + 1; j < end && points.arc_m[j] - points.arc_m[i] < distance_m; ++j) {
      if (points.area_m2[j] == 0.0F || points.vein[i] != points.vein[j]) continue;
      const glm::vec3 apart = points.position_m[i] - points.position_m[j];
      if (glm::dot(apart, apart) < distance_m * distance_m) merge_into(points, i, j);
    }
  }
}

}  // namespace wold::grass
