#include "grass/blade_tubes.h"

#include <cmath>
#include <numbers>

#include "grass/blade_light.h"

namespace wold::grass {
namespace {

constexpr int segments = 16;
constexpr int corners = 3;

void append_places(const BladePatch& patch, const AgeingModel& model, std::size_t i,
                   std::vector<BladePlace>& places) {
  const Blade& blade = patch.blades[i];
  const BladePose& pose = patch.poses[i];
  const float length_m = blade.length_m * pose.length_scale;
  const float specular = model.specular(patch.ages[i]);
  const BladeAxis axis(blade, pose);
  for (int step = 0; step <= segments; ++step) {
    const float along = static_cast<float>(step) / segments;
    const AxisPoint at = axis.at(length_m * along);
    places.push_back({static_cast<std::uint32_t>(i),
                      on_patch_m(blade, at),
                      blade.radius_m * pose.mesophyll_width * (1.0F - along),
                      {from_plane(blade, at.tangent),
                       model.albedo(blade, patch.ages[i], double{along}), specular}});
  }
}

void append_ring(const Blade& blade, const BladePlace& at, std::vector<glm::vec3>& vertices_m) {
  constexpr float pi = std::numbers::pi_v<float>;
  const float reach = at.radius_m * pi / (corners * std::sin(pi / corners));
  const glm::vec3 across(-blade.heading.y, blade.heading.x, 0.0F);
  const glm::vec3 side = glm::cross(across, at.fibre.tangent);
  for (int corner = 0; corner < corners; ++corner) {
    const float angle = 2.0F * pi * static_cast<float>(corner) / corners;
    vertices_m.push_back(at.position_m +
                         reach * (std::cos(angle) * across + std::sin(angle) * side));
  }
}

}  // namespace

Tubes blade_tubes(const BladePatch& patch, const AgeingModel& model, const Lighting& lighting,
                  const FibreLook& look) {
  std::vector<BladePlace> places;
  for (std::size_t i = 0; i < patch.blades.size(); ++i) append_places(patch, model, i, places);
  Tubes tubes{segments + 1, corners, {}, place_radiance(patch, places, lighting, look)};
  for (const BladePlace& place : places)
    append_ring(patch.blades[place.blade], place, tubes.vertices_m);
  return tubes;
}

}  // namespace wold::grass
