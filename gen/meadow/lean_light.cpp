#include "meadow/lean_light.h"

#include <algorithm>
#include <utility>

#include "core/colour.h"
#include "core/elementary.h"
#include "grass/optics/flat_leaf.h"
#include "place/each_in_view.h"

namespace wold::meadow {
namespace {

/// Fibres that were combed to `combed` and lean as `lean`.
std::vector<TurnedBlade> turned_blades(const std::vector<grass::Fibre>& fibres,
                                       const glm::dvec2& lean, const glm::dvec2& combed) {
  std::vector<TurnedBlade> blades;
  blades.reserve(fibres.size());
  for (const grass::Fibre& fibre : fibres)
    blades.push_back(turned_by_wind(fibre, glm::vec2(combed), glm::vec2(lean)));
  return blades;
}

constexpr float usually_sunlit = 0.5F;

/// Of a meadow, as typical_light() has it.
constexpr double leaf_area_index = 2.5;

/// Sine of the lowest direction that is told from the horizontal.
constexpr double flattest = 0.03;

/// Optical depth of the whole canopy along a direction: leaf area index times G over the cosine of
/// the zenith angle; G is half of what a leaf shows over its mean.
float canopy_depth(std::span<const TurnedBlade> blades, const glm::dvec3& direction) {
  double shown = 0.0;
  for (const TurnedBlade& blade : blades)
    shown += double{shown_area(blade, glm::vec3(direction))} / static_cast<double>(blades.size());
  return static_cast<float>(leaf_area_index * 0.5 * shown / std::max(direction.z, flattest));
}

/// What is left of a line of sight at a place of a blade, through what is above it in a canopy of
/// so great an optical depth: of blades that taper to their tips (1 - s)^2 of the area is above s.
float left_of_sight(float depth, float along) {
  const float below_tip = 1.0F - along;
  return math::exp(-depth * below_tip * below_tip);
}

/// Of radiances, by the areas that send them.
class WeightedMean {
 public:
  void add(float area, const glm::vec3& radiance) {
    sum_ += area * radiance;
    area_ += area;
  }
  glm::vec3 mean() const { return sum_ / area_; }

 private:
  glm::vec3 sum_{0.0F};
  float area_ = 0.0F;
};

/// Half of the sky, and what fibres scatter again: the fraction p of what one scatters meets
/// another (photon recollision, Smolander and Stenberg 2005), 0.45 for a canopy of leaf area index
/// 2 to 3.
grass::DiffuseLight typical_light(const std::vector<grass::Fibre>& fibres,
                                  const grass::Lighting& lighting) {
  constexpr float recollision = 0.45F;
  const grass::TurnedLight light(lighting, /*turn=*/0);
  grass::DiffuseLight diffuse;
  for (const grass::SkyDirection& sky : grass::sky_directions(lighting))
    diffuse.add(glm::vec3(sky.direction), 0.5F * sky.irradiance());
  glm::vec3 albedo(0.0F), taken(0.0F);
  for (const grass::Fibre& fibre : fibres) {
    albedo += fibre.albedo / static_cast<float>(fibres.size());
    taken += (usually_sunlit * light.sun_irradiance *
                  grass::kajiya_kay_diffuse(fibre.tangent, glm::vec3(light.sun)) +
              grass::leaf_share(diffuse, fibre.tangent, light.eye).taken) /
             static_cast<float>(fibres.size());
  }
  diffuse.add_even(recollision * albedo / (1.0F - recollision * albedo) * taken);
  return diffuse;
}

}  // namespace

LeanLight::LeanLight(std::vector<grass::Fibre> fibres, grass::Lighting lighting,
                     float specular_exponent)
    : fibres_(std::move(fibres)),
      lighting_(std::move(lighting)),
      diffuse_(typical_light(fibres_, lighting_)),
      specular_exponent_(specular_exponent) {
  const grass::TurnedLight light(lighting_, /*turn=*/0);
  upright_ = glm::vec3(0.0F);
  for (const grass::Fibre& fibre : fibres_)
    upright_ += grass::source_radiance(fibre, light, usually_sunlit, diffuse_, specular_exponent_) /
                static_cast<float>(fibres_.size());
}

LeanLight::Seen LeanLight::seen(std::span<const TurnedBlade> blades, const glm::dvec3& to_eye,
                                float sunlit) const {
  grass::TurnedLight light(lighting_, /*turn=*/0);
  light.eye = glm::vec3(to_eye);
  const float depth = canopy_depth(blades, to_eye);
  WeightedMean all, tips;
  for (const TurnedBlade& blade : blades) {
    const float not_hidden = left_of_sight(depth, blade.fibre.along);
    constexpr float least = 1e-6F;  // where one looks along all of them, all count
    const auto add = [&](float shown, const glm::vec3& radiance) {
      const float area = std::max(shown, least);
      all.add(area, radiance);
      tips.add(not_hidden * area, radiance);
    };
    add((1.0F - blade.turned) * grass::kajiya_kay_diffuse(blade.fibre.tangent, light.eye),
        grass::source_radiance(blade.fibre, light, sunlit, diffuse_, specular_exponent_));
    if (blade.turned == 0.0F) continue;
    add(blade.turned * grass::flat_leaf_area(blade.normal, light.eye),
        grass::flat_leaf_radiance(blade.fibre, blade.normal, light, sunlit, diffuse_,
                                  specular_exponent_));
  }
  return {all.mean(), tips.mean()};
}

glm::vec3 LeanLight::factor(const glm::dvec2& lean, const glm::dvec3& to_eye) const {
  return seen(turned_blades(fibres_, lean, lean), to_eye, usually_sunlit).all /
         glm::max(upright_, 1e-6F);
}

glm::vec3 LeanLight::factor(const glm::dvec2& lean, const glm::dvec2& combed,
                            const glm::dvec3& to_eye) const {
  if (lean == combed) return factor(lean, to_eye);
  const std::vector<TurnedBlade> before = turned_blades(fibres_, combed, combed);
  const std::vector<TurnedBlade> now = turned_blades(fibres_, lean, combed);
  const double more = sunlit_share(now, to_eye) / sunlit_share(before, to_eye);
  const auto sunlit = static_cast<float>(std::min(double{usually_sunlit} * more, 1.0));
  const Seen was = seen(before, to_eye, usually_sunlit);
  return was.all / glm::max(upright_, 1e-6F) * seen(now, to_eye, sunlit).tips /
         glm::max(was.tips, 1e-6F);
}

double LeanLight::sunlit_share(const glm::dvec2& lean, const glm::dvec2& combed,
                               const glm::dvec3& to_eye) const {
  return sunlit_share(turned_blades(fibres_, lean, combed), to_eye);
}

double LeanLight::sunlit_share(std::span<const TurnedBlade> blades,
                               const glm::dvec3& to_eye) const {
  double to_sun = 0.0, to_see = 0.0;
  for (const TurnedBlade& blade : blades) {
    to_sun += double{shown_area(blade, glm::vec3(lighting_.sun_direction))};
    to_see += double{shown_area(blade, glm::vec3(to_eye))};
  }
  const double sun = to_sun / std::max(lighting_.sun_direction.z, flattest);
  const double eye = to_see / std::max(to_eye.z, flattest);
  return eye / (eye + sun);
}

ColourMap lean_light_map(const LeanLight& light, const WindLean& wind_lean,
                         const Heightfield& terrain, const place::View& view) {
  constexpr double step_m = 0.4;
  return lean_light_map(light, wind_lean, terrain, view,
                        {{.size_m = terrain.size_m()}, map_samples(terrain.size_m(), step_m)});
}

ColourMap lean_light_map(const LeanLight& light, const WindLean& wind_lean,
                         const Heightfield& terrain, const place::View& view,
                         const GroundGrid& grid) {
  ColourMap map(grid.samples, grid.square, glm::vec3(1.0F));
  place::each_in_view(map, terrain, view, [&](int i, int j, const glm::dvec3& at_m) {
    const glm::dvec2 place_m(at_m);
    map.at(i, j) =
        light.factor(wind_lean.lean(place_m), wind_lean.combed(place_m), -view.line_of_sight(at_m));
  });
  return map;
}

}  // namespace wold::meadow
