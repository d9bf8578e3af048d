#include "grass/geometry/blade_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grass/geometry/axis.h"
#include "grass/geometry/snow_ridge.h"

namespace wold::grass {
namespace {

constexpr int segments = BladePlaces::per_blade - 1;

void append_places(const BladePatch& patch, const MeadowModel& meadow, std::size_t i,
                   std::vector<BladePlace>& places) {
  const Blade& blade = patch.blades[i];
  const BladePose& pose = patch.poses[i];
  const AgeingModel& model = meadow.of(blade);
  const float length_m = blade.length_m * pose.length_scale;
  const float specular = model.specular(blade, patch.ages[i]);
  const BladeAxis axis(blade, pose);
  for (int step = 0; step <= segments; ++step) {
    const float along = static_cast<float>(step) / segments;
    const AxisPoint at = axis.at(length_m * along);
    const LeafShade leaf = model.shade(blade, patch.ages[i], double{along});
    const float radius_m = blade.radius_m * pose.mesophyll_width * (1.0F - along);
    places.push_back({static_cast<std::uint32_t>(i),
                      on_patch_m(blade, at),
                      radius_m,
                      0.5F * std::numbers::pi_v<float> * radius_m * length_m / segments,
                      {from_plane(blade, at.tangent), leaf.albedo, leaf.transmittance, specular},
                      along});
  }
}

/// What a ridge shows across its length, the mean over all sides: half of what a round one does
/// whose outline is as long.
float mean_width_m(const SnowRidge& ridge) {
  const float radius_m = std::sqrt(
      0.5F * (ridge.half_width_m * ridge.half_width_m + ridge.half_height_m * ridge.half_height_m));
  return 0.5F * std::numbers::pi_v<float> * radius_m;
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
                     foot_m(blade) + from_plane(blade, ridge.centre_m),
                     ridge.half_width_m,
                     length_m * (end - begin) / segments * mean_width_m(ridge),
                     {from_plane(blade, at.tangent), snow_albedo, glm::vec3(0.0F), 0.0F},
                     along});
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

BladePlaces blade_places(const BladePatch& patch, const MeadowModel& model) {
  BladePlaces result;
  std::uint32_t stalk = 0;
  for (std::uint32_t i = 0; i < patch.blades.size(); ++i) {
    append_places(patch, model, i, result.places);
    if (!sits_on_stalk(patch.blades[i])) stalk = i;
    result.carried_by.push_back(stalk);
  }
  result.of_blades = result.places.size();
  for (std::size_t i = 0; i < patch.blades.size(); ++i)
    append_snow(patch, i, result.places, result.snow_half_height_m);
  return result;
}

}  // namespace wold::grass
