#include "passes/leaf_albedo.h"

#include <map>
#include <utility>

#include "landscape/voxel_albedo.h"

namespace wold::passes {
namespace {

std::size_t voxel_at(const landscape::Landscape& landscape, const SeenPlace& seen) {
  const landscape::Cell& cell = landscape.cells[static_cast<std::size_t>(seen.cell)];
  const landscape::Volume& volume = landscape.volumes[static_cast<std::size_t>(cell.volume)];
  const glm::dvec3 at_m(glm::inverse(cell.world_from_cell) * glm::dvec4(seen.at_m, 1.0));
  const glm::dvec2 in_patch = glm::fract(glm::dvec2(at_m) / landscape.patch_m) * landscape.patch_m;
  const glm::ivec3 voxel =
      glm::clamp(glm::ivec3(glm::floor(glm::dvec3(in_patch, at_m.z) / volume.voxel_m)),
                 glm::ivec3(0), volume.voxels - 1);
  const auto side = static_cast<std::size_t>(volume.voxels.x);
  return (static_cast<std::size_t>(voxel.z) * side + static_cast<std::size_t>(voxel.y)) * side +
         static_cast<std::size_t>(voxel.x);
}

/// Half-way between two rings. Where only its radiance is known nothing is.
glm::vec3 blade_albedo(const landscape::Landscape& landscape, const SeenPlace& seen) {
  const landscape::BladeCell& cell = landscape.blade_cells[static_cast<std::size_t>(seen.cell)];
  const Tubes& tubes = *landscape.blade_meshes[static_cast<std::size_t>(cell.mesh)].tubes;
  if (tubes.reflectance.empty()) return glm::vec3(0.0F);
  glm::vec3 sum(0.0F);
  for (const std::size_t ring : {seen.ring, seen.ring + 1})
    sum += tubes.reflectance[ring] + tubes.transmittance[ring];
  return 0.5F * sum;
}

/// Pixels by the volume that they show. Those that differ in their light alone count as one.
std::map<std::filesystem::path, std::vector<std::size_t>> by_volume(
    const landscape::Landscape& landscape, std::span<const SeenPlace> seen) {
  std::map<std::filesystem::path, std::vector<std::size_t>> pixels;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].thing != SeenPlace::Thing::volume) continue;
    const landscape::Cell& cell = landscape.cells[static_cast<std::size_t>(seen[i].cell)];
    pixels[landscape.volumes[static_cast<std::size_t>(cell.volume)].vdb].push_back(i);
  }
  return pixels;
}

}  // namespace

std::vector<glm::vec3> leaf_albedo(const landscape::Landscape& landscape,
                                   std::span<const SeenPlace> seen) {
  std::vector<glm::vec3> albedo(seen.size(), glm::vec3(0.0F));
  for (const auto& [file, pixels] : by_volume(landscape, seen)) {
    const landscape::Cell& cell =
        landscape.cells[static_cast<std::size_t>(seen[pixels.front()].cell)];
    const std::vector<glm::vec3> voxels =
        landscape::voxel_albedo(landscape.volumes[static_cast<std::size_t>(cell.volume)]);
    for (const std::size_t pixel : pixels) albedo[pixel] = voxels[voxel_at(landscape, seen[pixel])];
  }
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (seen[i].thing == SeenPlace::Thing::blade) albedo[i] = blade_albedo(landscape, seen[i]);
  return albedo;
}

}  // namespace wold::passes
