#include "grass/optics/diffuse_light.h"

#include <numbers>

#include "grass/optics/leaf_phase.h"

namespace wold::grass {

glm::vec3 second_moment(const DiffuseLight& light, const glm::vec3& v) {
  const std::array<glm::vec3, 6>& second = light.second;
  return v.x * v.x * second[0] + v.y * v.y * second[1] + v.z * v.z * second[2] +
         2.0F * (v.x * v.y * second[3] + v.x * v.z * second[4] + v.y * v.z * second[5]);
}

void DiffuseLight::add(const glm::vec3& d, const glm::vec3& irradiance) {
  sum += irradiance;
  for (int i = 0; i < 3; ++i) flux[static_cast<std::size_t>(i)] += d[i] * irradiance;
  const std::array<float, 6> products = {d.x * d.x, d.y * d.y, d.z * d.z,
                                         d.x * d.y, d.x * d.z, d.y * d.z};
  for (std::size_t i = 0; i < products.size(); ++i) second[i] += products[i] * irradiance;
}

void DiffuseLight::add(const DiffuseLight& other) {
  sum += other.sum;
  for (std::size_t i = 0; i < flux.size(); ++i) flux[i] += other.flux[i];
  for (std::size_t i = 0; i < second.size(); ++i) second[i] += other.second[i];
}

void DiffuseLight::add_even(const glm::vec3& even_sum) {
  sum += even_sum;
  for (std::size_t i = 0; i < 3; ++i) second[i] += even_sum / 3.0F;
}

LeafShare leaf_share(const DiffuseLight& light, const glm::vec3& tangent, const glm::vec3& eye) {
  constexpr float pi = std::numbers::pi_v<float>;
  // Least squares of sqrt(1 - c^2) by a + b c^2, for all directions alike.
  constexpr float a = 1.0308F, b = -0.7363F;
  // The phase's even part as a + b c^2 with a mean of 1 about the axis.
  constexpr float level = 0.785F, rise = 0.43F;
  const glm::vec3 e = seen_along(tangent, eye);
  const glm::vec3 taken = 4.0F / pi * (a * light.sum + b * second_moment(light, tangent));
  const glm::vec3 even = level * taken + 1.5F * rise * second_moment(light, e);
  const glm::vec3 odd =
      0.5F * pi * (e.x * light.flux[0] + e.y * light.flux[1] + e.z * light.flux[2]);
  return {taken, even + odd, even - odd};
}

}  // namespace wold::grass
