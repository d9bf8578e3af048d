#include "grass/optics/blade_light.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "grass/optics/blade_picture.h"

namespace wold::grass {
namespace {

/// Which of the light from one direction reaches the blades.
class Shadows {
 public:
  Shadows(const std::vector<Piece>& pieces, double patch_m, const glm::dvec3& direction,
          double pixel_m)
      : direction_(direction),
        picture_(pieces, patch_m, direction,
                 std::clamp(static_cast<int>(patch_m / pixel_m), 64, 4096)) {}

  /// Fraction of a blade's width at a place that is not in shadow.
  float reaching(const BladePlace& place) const {
    const glm::vec3 across = glm::cross(place.fibre.tangent, direction_);
    const float sine = glm::length(across);
    const glm::vec3 step = sine > 1e-3F ? across * (place.radius_m / sine) : glm::vec3(0.0F);
    int lit = 0;
    for (const float offset : {-0.75F, -0.25F, 0.25F, 0.75F})
      if (!picture_.hides(place.position_m + offset * step, place.blade)) ++lit;
    return static_cast<float>(lit) / 4.0F;
  }

 private:
  glm::vec3 direction_;
  BladePicture picture_;
};

}  // namespace

std::vector<glm::vec3> place_radiance(const BladePatch& patch, std::span<const BladePlace> places,
                                      const Lighting& lighting, const FibreLook& look,
                                      double shadow_pixel_m) {
  const TurnedLight light(lighting, /*turn=*/0);
  const std::vector<Piece> pieces = BladePicture::pieces_of(patch);
  // One picture at a time: the sun, then every direction of the sky.
  const auto each_place = [&](const glm::dvec3& direction, const auto& visit) {
    const Shadows shadows(pieces, patch.patch_m, direction, shadow_pixel_m);
    parallel_for(places.size(), [&](std::size_t i) { visit(i, shadows.reaching(places[i])); });
  };
  std::vector<float> sunlit(places.size());
  each_place(light.sun, [&](std::size_t i, float fraction) { sunlit[i] = fraction; });
  std::vector<glm::vec3> skylight(places.size(), glm::vec3(0.0F));
  for (const SkyDirection& sky : sky_directions(lighting))
    each_place(sky.direction, [&](std::size_t i, float fraction) {
      skylight[i] += sky.irradiance * (fraction * kajiya_kay_diffuse(places[i].fibre.tangent,
                                                                     glm::vec3(sky.direction)));
    });
  std::vector<glm::vec3> radiance;
  for (std::size_t i = 0; i < places.size(); ++i)
    radiance.push_back(
        source_radiance(places[i].fibre, light, sunlit[i], skylight[i], look.specular_exponent));
  return radiance;
}

}  // namespace wold::grass
