#include "grass/geometry/point_tubes.h"

#include <cmath>

#include "grass/optics/blade_light.h"
#include "grass/texel/snow_points.h"

namespace wold::grass {
namespace {

constexpr int corners = 4;

/// From the centre of an octahedron to its corners when it shows `area_m2` on average: by Cauchy a
/// quarter of its surface, which is sqrt(3) reach^2.
float octahedron_reach_m(float area_m2) { return std::sqrt(area_m2 / std::sqrt(3.0F)); }

/// The points of one sample that were not merged into others.
void append_places(const Points& points, std::uint32_t first_blade,
                   std::vector<BladePlace>& places) {
  for (std::uint32_t blade = 0; blade < points.blades(); ++blade)
    for (std::uint32_t i = points.blade_begin[blade]; i < points.blade_begin[blade + 1]; ++i)
      if (points.area_m2[i] > 0.0F)
        places.push_back(
            {first_blade + blade,
             points.position_m[i],
             octahedron_reach_m(points.area_m2[i]),
             points.area_m2[i],
             {points.tangent[i], points.albedo[i], points.transmittance[i], points.specular[i]}});
}

/// Tip, waist and tip.
void append_octahedron(const BladePlace& place, std::vector<glm::vec3>& vertices_m) {
  const glm::vec3 along = place.radius_m * place.fibre.tangent;
  const glm::vec3 away =
      std::abs(place.fibre.tangent.z) < 0.9F ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  const glm::vec3 across = place.radius_m * glm::normalize(glm::cross(away, place.fibre.tangent));
  const glm::vec3 side = glm::cross(across, place.fibre.tangent);
  vertices_m.insert(vertices_m.end(), corners, place.position_m - along);
  for (const glm::vec3& corner : {across, side, -across, -side})
    vertices_m.push_back(place.position_m + corner);
  vertices_m.insert(vertices_m.end(), corners, place.position_m + along);
}

}  // namespace

Tubes point_tubes(const BladePatch& patch, std::span<const PointDynamics> samples,
                  const Lighting& lighting, const FibreLook& look, double snow_step_m) {
  std::vector<BladePlace> places;
  std::uint32_t first_blade = 0;
  for (const PointDynamics& sample : samples) {
    append_places(sample.points(), first_blade, places);
    append_places(snow_points(sample.blades(), sample.poses(), snow_step_m), first_blade, places);
    first_blade += static_cast<std::uint32_t>(sample.points().blades());
  }
  constexpr int rings = 3;
  Tubes tubes{rings, corners, {}, {}};
  for (const glm::vec3& radiance : place_radiance(patch, places, lighting, look))
    tubes.radiance.insert(tubes.radiance.end(), rings, radiance);
  for (const BladePlace& place : places) append_octahedron(place, tubes.vertices_m);
  return tubes;
}

}  // namespace wold::grass
