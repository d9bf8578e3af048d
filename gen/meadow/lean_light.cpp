#include "meadow/lean_light.h"

#include <utility>

#include "core/colour.h"
#include "place/each_in_view.h"

namespace wold::meadow {
namespace {

/// A fibre after the shear that leans the grass over.
grass::Fibre leaning(grass::Fibre fibre, const glm::vec2& lean) {
  fibre.tangent = glm::normalize(fibre.tangent + glm::vec3(lean * fibre.tangent.z, 0.0F));
  return fibre;
}

}  // namespace

LeanLight::LeanLight(std::vector<grass::Fibre> fibres, grass::Lighting lighting,
                     float specular_exponent)
    : fibres_(std::move(fibres)),
      lighting_(std::move(lighting)),
      skylight_(0.0F),
      specular_exponent_(specular_exponent) {
  for (const grass::SkyDirection& sky : grass::sky_directions(lighting_))
    skylight_ += 0.5F * sky.irradiance;
  upright_ = radiance(glm::dvec2(0.0), lighting_.eye_direction);
}

glm::vec3 LeanLight::radiance(const glm::dvec2& lean, const glm::dvec3& to_eye) const {
  constexpr float sunlit = 0.5F;
  grass::TurnedLight light(lighting_, /*turn=*/0);
  light.eye = glm::vec3(to_eye);
  glm::vec3 sum(0.0F);
  for (const grass::Fibre& fibre : fibres_)
    sum += grass::source_radiance(leaning(fibre, glm::vec2(lean)), light, sunlit, skylight_,
                                  specular_exponent_);
  return sum;
}

float LeanLight::factor(const glm::dvec2& lean, const glm::dvec3& to_eye) const {
  return luminance(radiance(lean, to_eye)) / luminance(upright_);
}

FactorMap lean_light_map(const LeanLight& light, const WindLean& wind_lean,
                         const Heightfield& terrain, const place::View& view) {
  constexpr double step_m = 0.4;
  return lean_light_map(light, wind_lean, terrain, view,
                        {{.size_m = terrain.size_m()}, map_samples(terrain.size_m(), step_m)});
}

FactorMap lean_light_map(const LeanLight& light, const WindLean& wind_lean,
                         const Heightfield& terrain, const place::View& view,
                         const GroundGrid& grid) {
  FactorMap map(grid.samples, grid.square, 1.0F);
  place::each_in_view(map, terrain, view, [&](int i, int j, const glm::dvec3& at_m) {
    map.at(i, j) = light.factor(wind_lean.lean(glm::dvec2(at_m)), -view.line_of_sight(at_m));
  });
  return map;
}

}  // namespace wold::meadow
