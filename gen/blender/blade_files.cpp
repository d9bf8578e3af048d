#include "blender/blade_files.h"

#include <vector>

#include "blender/arrays.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;

/// Every corner of a ring has the ring's radiance.
std::vector<glm::vec3> radiance_of_vertices(const Tubes& tubes) {
  std::vector<glm::vec3> result;
  for (const glm::vec3& radiance : tubes.radiance)
    result.insert(result.end(), static_cast<std::size_t>(tubes.corners), radiance);
  return result;
}

constexpr const char* parts[] = {".vertices.f32", ".radiance.f32", ".quads.i32"};

}  // namespace

std::vector<fs::path> blade_files(const std::string& name, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const char* part : parts) files.push_back(folder / (name + part));
  return files;
}

void write_blades(const landscape::BladeMesh& mesh, const fs::path& folder) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
  const auto write_once = [&](const char* part, const auto& values) {
    const fs::path path = folder / (mesh.name + part);
    if (!fs::exists(path)) write_array(path, values);
  };
  write_once(parts[0], mesh.tubes->vertices_m);
  write_once(parts[1], radiance_of_vertices(*mesh.tubes));
  write_once(parts[2], quad_corners(*mesh.tubes));
}

}  // namespace wold::blender
