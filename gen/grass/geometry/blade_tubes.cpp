#include "grass/geometry/blade_tubes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "grass/geometry/snow_ridge.h"
#include "grass/optics/blade_light.h"

namespace wold::grass {
namespace {

constexpr int segments = 16;
constexpr int corners = 3;
constexpr float pi = std::numbers::pi_v<float>;

void append_places(const BladePatch& patch, const MeadowModel& meadow, std::size_t i,
                   std::vector<BladePlace>& places) {
  const Blade& blade = patch.blades[i];
  const BladePose& pose = patch.poses[i];
  const AgeingModel& model = meadow.of(blade);
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

/// Snow on a part of a blade, from `begin` to `end` of it: a tube whose rings' half heights follow
/// their places. Nothing where no snow lies.
void append_snow(const BladePatch& patch, std::size_t i, const BladeAxis& axis, float begin,
                 float end, std::vector<BladePlace>& places, std::vector<float>& half_heights_m) {
  const Blade& blade = patch.blades[i];
  const float length_m = blade.length_m * patch.poses[i].length_scale;
  std::vector<BladePlace> rings;
  std::vector<float> heights_m;
  float highest_m = 0.0F;
  for (int step = 0; step <= segments; ++step) {
    const float along = std::lerp(begin, end, static_cast<float>(step) / segments);
    const AxisPoint at = axis.at(length_m * along);
    const SnowRidge ridge = snow_ridge(blade, patch.poses[i], along, at);
    rings.push_back({static_cast<std::uint32_t>(i),
                     glm::vec3(blade.root_m, 0.0F) + from_plane(blade, ridge.centre_m),
                     ridge.half_width_m,
                     {from_plane(blade, at.tangent), snow_albedo, 0.0F}});
    heights_m.push_back(ridge.half_height_m);
    highest_m = std::max(highest_m, ridge.half_height_m);
  }
  if (highest_m == 0.0F) return;
  places.insert(places.end(), rings.begin(), rings.end());
  half_heights_m.insert(half_heights_m.end(), heights_m.begin(), heights_m.end());
}

void append_snow(const BladePatch& patch, std::size_t i, std::vector<BladePlace>& places,
                 std::vector<float>& half_heights_m) {
  if (patch.poses[i].snow <= 0.0F) return;
  const BladeAxis axis(patch.blades[i], patch.poses[i]);
  append_snow(patch, i, axis, 0.0F, 0.5F, places, half_heights_m);
  append_snow(patch, i, axis, 0.5F, 1.0F, places, half_heights_m);
}

}  // namespace

Tubes blade_tubes(const BladePatch& patch, const MeadowModel& model, const Lighting& lighting,
                  const FibreLook& look, double shadow_pixel_m) {
  std::vector<BladePlace> places;
  for (std::size_t i = 0; i < patch.blades.size(); ++i) append_places(patch, model, i, places);
  const std::size_t of_blades = places.size();
  std::vector<float> half_heights_m;
  for (std::size_t i = 0; i < patch.blades.size(); ++i)
    append_snow(patch, i, places, half_heights_m);
  Tubes tubes{
      segments + 1, corners, {}, place_radiance(patch, places, lighting, look, shadow_pixel_m)};
  for (std::size_t k = 0; k < of_blades; ++k)
    append_ring(patch.blades[places[k].blade], places[k], 1.0F, 0.0F, tubes.vertices_m);
  for (std::size_t k = of_blades; k < places.size(); ++k) {
    const float width_m = places[k].radius_m;
    const float height = width_m > 0.0F ? half_heights_m[k - of_blades] / width_m : 0.0F;
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
    for (int step = 0; step <= segments; ++step, ++ring) {
      const double along = static_cast<double>(step) / segments;
      const LeafShade shade =
          model.of(patch.blades[i]).shade(patch.blades[i], patch.ages[i], along);
      tubes.reflectance[ring] = shade.reflectance;
      tubes.transmittance[ring] = shade.transmittance;
    }
}

}  // namespace wold::grass
