#include "grass/geometry/blade_tubes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "grass/geometry/blade_places.h"
#include "grass/geometry/snow_ridge.h"

namespace wold::grass {
namespace {

constexpr int corners = 3;
constexpr float pi = std::numbers::pi_v<float>;

/// The ring around a place, `height` times as high as it is wide, its first corner turned by
/// `first` from the level one.
void append_ring(const Blade& blade, const BladePlace& at, float height, float first,
                 std::vector<glm::vec3>& vertices_m) {
  const float reach = at.radius_m * pi / (corners * math::sin(pi / corners));
  const glm::vec3 across(-blade.heading.y, blade.heading.x, 0.0F);
  const glm::vec3 side = glm::cross(across, at.fibre.tangent);
  for (int corner = 0; corner < corners; ++corner) {
    const float angle = first + 2.0F * pi * static_cast<float>(corner) / corners;
    vertices_m.push_back(at.position_m +
                         reach * (math::cos(angle) * across + math::sin(angle) * height * side));
  }
}

}  // namespace

Tubes blade_tubes(const BladePatch& patch, const MeadowModel& model, const Lighting& lighting,
                  const FibreLook& look, double shadow_pixel_m) {
  const BladePlaces all = blade_places(patch, model);
  const std::vector<BladePlace>& places = all.places;
  Tubes tubes{BladePlaces::per_blade,
              corners,
              {},
              place_radiance(patch, places, lighting, look, shadow_pixel_m)};
  for (std::size_t k = 0; k < all.of_blades; ++k)
    append_ring(patch.blades[places[k].blade], places[k], 1.0F, 0.0F, tubes.vertices_m);
  for (std::size_t k = all.of_blades; k < places.size(); ++k) {
    const float width_m = places[k].radius_m;
    const float height =
        width_m > 0.0F ? all.snow_half_height_m[k - all.of_blades] / width_m : 0.0F;
    // The side of a blade's section looks down: a corner on top.
    append_ring(patch.blades[places[k].blade], places[k], height, -pi / 2.0F, tubes.vertices_m);
  }
  return tubes;
}

void add_leaf_shades(const BladePatch& patch, const MeadowModel& model, Tubes& tubes) {
  // Tubes of snow follow those of the blades.
  tubes.reflectance.assign(tubes.rings_of_all(), snow_albedo);
  tubes.transmittance.assign(tubes.rings_of_all(), glm::vec3(0.0F));
  std::size_t ring = 0;
  for (std::size_t i = 0; i < patch.blades.size(); ++i)
    for (int step = 0; step < BladePlaces::per_blade; ++step, ++ring) {
      const double along = static_cast<double>(step) / (BladePlaces::per_blade - 1);
      const LeafShade shade =
          model.of(patch.blades[i]).shade(patch.blades[i], patch.ages[i], along);
      tubes.reflectance[ring] = shade.reflectance;
      tubes.transmittance[ring] = shade.transmittance;
    }
}

}  // namespace wold::grass
