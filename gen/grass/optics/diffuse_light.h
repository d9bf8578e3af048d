#pragma once

#include <array>
#include <glm/glm.hpp>

namespace wold::grass {

/// Light that comes to a place from many directions at once: the moments of its radiance over them.
struct DiffuseLight {
  glm::vec3 sum{0.0F};                ///< integral of the radiance
  std::array<glm::vec3, 3> flux{};    ///< of radiance times d, by x, y and z of d
  std::array<glm::vec3, 6> second{};  ///< of radiance times d d^T: xx, yy, zz, xy, xz, yz

  /// Adds light from a unit direction d, which points to where it comes from: radiance times solid
  /// angle.
  void add(const glm::vec3& direction, const glm::vec3& irradiance);
  void add(const DiffuseLight& other);
  /// Adds light from all sides alike; `sum` is the integral of its radiance.
  void add_even(const glm::vec3& even_sum);
};

/// The integral of radiance times (v d)^2 over the directions d it comes from.
glm::vec3 second_moment(const DiffuseLight& light, const glm::vec3& v);

/// Of diffuse light, what a leaf takes that is turned about its axis by any angle, and what of it
/// is sent to an eye over what is sent to all directions on average (leaf_phase() in shading.h).
struct LeafShare {
  glm::vec3 taken;        ///< weighted by kajiya_kay_diffuse()
  glm::vec3 reflected;    ///< taken, times the phase of what is reflected
  glm::vec3 transmitted;  ///< taken, times the phase of what is let through
};

/// `tangent` and `eye` are unit; the eye's direction points away from the leaf. The sine of the
/// angle between leaf and light is taken as a parabola of its cosine, which is 5 % off at most for
/// light that comes from a half of all directions or more.
LeafShare leaf_share(const DiffuseLight& light, const glm::vec3& tangent, const glm::vec3& eye);

}  // namespace wold::grass
