#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace wold::mitsuba {

/// Triangles with a place in a picture for each corner.
struct Mesh {
  struct Vertex {
    glm::vec3 place_m;
    glm::vec2 uv;  ///< in the picture, from its upper left corner
  };
  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside

  /// Appends the two triangles of a quadrilateral, without those that have no area since two of
  /// their corners are one place.
  void add_quad(const std::array<std::uint32_t, 4>& corners);
};

/// The bytes of a binary little-endian PLY file: per vertex the floats x, y, z, u, v; per face a
/// count of one byte, 3, and three 32-bit indices.
std::string ply_bytes(const Mesh& mesh);

}  // namespace wold::mitsuba
