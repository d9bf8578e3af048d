#include "grass/optics/flat_leaf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grass/optics/leaf_phase.h"

namespace wold::grass {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// How much of the highlight a leaf sends to the eye over the mean over all turns about its axis.
float highlight_share(const glm::vec3& tangent, const glm::vec3& normal, const glm::vec3& light,
                      const glm::vec3& eye) {
  const glm::vec3 half_way = seen_along(tangent, light) + seen_along(tangent, eye);
  const float length = glm::length(half_way);
  if (length < 1e-6F) return 0.0F;
  return 0.5F * pi * std::abs(glm::dot(normal, half_way)) / length;
}

}  // namespace

glm::vec3 irradiance_of_side(const DiffuseLight& light, const glm::vec3& normal) {
  const glm::vec3 first =
      normal.x * light.flux[0] + normal.y * light.flux[1] + normal.z * light.flux[2];
  const glm::vec3 side =
      3.0F / 32.0F * light.sum + 0.5F * first + 15.0F / 32.0F * second_moment(light, normal);
  return glm::max(side, 0.0F);
}

float flat_leaf_area(const glm::vec3& normal, const glm::vec3& direction) {
  return 2.0F * std::abs(glm::dot(normal, direction));
}

glm::vec3 flat_leaf_radiance(const Fibre& fibre, const glm::vec3& normal, const TurnedLight& light,
                             float sunlit, const DiffuseLight& diffuse, float specular_exponent) {
  const glm::vec3 seen = glm::dot(normal, light.eye) < 0.0F ? -normal : normal;
  const glm::vec3 sun(light.sun);
  const glm::vec3 direct = light.sun_irradiance * sunlit;
  const float facing = glm::dot(seen, sun);
  const glm::vec3 sky = irradiance_of_side(diffuse, seen);
  const glm::vec3 on_seen = std::max(facing, 0.0F) * direct + sky;
  const glm::vec3 on_other = std::max(-facing, 0.0F) * direct + irradiance_of_side(diffuse, -seen);
  const glm::vec3 reflectance = fibre.albedo - fibre.transmittance;
  const glm::vec3 mirrored = mirrored_fraction(fibre, specular_exponent);
  const float mirror = kajiya_kay_specular(fibre.tangent, sun, light.eye, specular_exponent) /
                       highlight_albedo(specular_exponent) *
                       highlight_share(fibre.tangent, seen, sun, light.eye);
  return 1.0F / pi *
         ((reflectance - mirrored) * on_seen + fibre.transmittance * on_other +
          mirrored * (0.25F * mirror * direct + sky));
}

}  // namespace wold::grass
