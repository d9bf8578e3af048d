#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace wold {

/// Bent, tapering tubes that glow by themselves: blades of grass as a renderer's mesh. Every tube
/// has the same number of rings, every ring the same number of corners.
struct Tubes {
  int rings = 0;
  int corners = 0;
  std::vector<glm::vec3> vertices_m;  ///< tube by tube, ring by ring, corner by corner
  std::vector<glm::vec3> radiance;    ///< tube by tube, ring by ring
  /// Fractions of the light on a leaf that it sends back and lets through, tube by tube, ring by
  /// ring; empty where only its radiance is known.
  std::vector<glm::vec3> reflectance = {};
  std::vector<glm::vec3> transmittance = {};

  std::size_t rings_of_all() const { return radiance.size(); }
  std::size_t count() const {
    return rings == 0 ? 0 : radiance.size() / static_cast<std::size_t>(rings);
  }
};

/// The corners of each quadrilateral, four per face, as indices into Tubes::vertices_m; outsides
/// are counter-clockwise. Tubes are open at both ends.
std::vector<std::uint32_t> quad_corners(const Tubes& tubes);

}  // namespace wold
