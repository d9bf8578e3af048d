#include "mitsuba/ply_file.h"

#include <fmt/format.h>

#include <bit>

namespace wold::mitsuba {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::string header(const Mesh& mesh) {
  return fmt::format(
      "ply\n"
      "format binary_little_endian 1.0\n"
      "element vertex {}\n"
      "property float x\n"
      "property float y\n"
      "property float z\n"
      "property float u\n"
      "property float v\n"
      "element face {}\n"
      "property list uchar int vertex_indices\n"
      "end_header\n",
      mesh.vertices.size(), mesh.triangles.size());
}

}  // namespace

void Mesh::add_quad(const std::array<std::uint32_t, 4>& corners) {
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::vec3 &at_a = vertices[a].place_m, &at_b = vertices[b].place_m,
                    &at_c = vertices[c].place_m;
    if (at_a != at_b && at_b != at_c && at_c != at_a) triangles.push_back({a, b, c});
  };
  add(corners[0], corners[1], corners[2]);
  add(corners[0], corners[2], corners[3]);
}

std::string ply_bytes(const Mesh& mesh) {
  constexpr std::size_t vertex_bytes = 5 * sizeof(float), face_bytes = 1 + 3 * sizeof(int);
  static_assert(sizeof(Mesh::Vertex) == vertex_bytes);
  std::string bytes = header(mesh);
  bytes.reserve(bytes.size() + vertex_bytes * mesh.vertices.size() +
                face_bytes * mesh.triangles.size());
  for (const Mesh::Vertex& vertex : mesh.vertices) append(bytes, vertex);
  for (const auto& triangle : mesh.triangles) {
    bytes.push_back(3);
    append(bytes, triangle);
  }
  return bytes;
}

}  // namespace wold::mitsuba
