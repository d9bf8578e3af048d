#include "landscape/voxel_albedo.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/vdb_file.h"

namespace wold::landscape {
namespace {

namespace fs = std::filesystem;

template <class Grid>
typename Grid::Ptr read_grid(const fs::path& path, const char* name) {
  const auto grid = openvdb::gridPtrCast<Grid>(read_vdb_grid(path, name));
  if (!grid)
    throw FileError(fmt::format("{}: the grid \"{}\" is of another type", path.string(), name));
  return grid;
}

/// Colours with weights: their mean where there is any weight.
struct Sum {
  glm::dvec3 weighted{0.0};
  double weight = 0.0;

  void add(const openvdb::Vec3s& colour, double by) {
    weighted += by * glm::dvec3(colour.x(), colour.y(), colour.z());
    weight += by;
  }
  glm::vec3 mean_or(const glm::vec3& other) const {
    return weight > 0.0 ? glm::vec3(weighted / weight) : other;
  }
};

/// Index of the voxel of a volume that a place in cell space lies in, x fastest.
std::size_t voxel_at(const Volume& volume, const openvdb::Vec3d& place_m) {
  const glm::dvec3 at = glm::dvec3(place_m.x(), place_m.y(), place_m.z()) / volume.voxel_m;
  const glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::floor(at)), glm::ivec3(0), volume.voxels - 1);
  return static_cast<std::size_t>(voxel.x) +
         static_cast<std::size_t>(volume.voxels.x) *
             (static_cast<std::size_t>(voxel.y) +
              static_cast<std::size_t>(volume.voxels.y) * static_cast<std::size_t>(voxel.z));
}

}  // namespace

std::vector<glm::vec3> voxel_albedo(const Volume& volume) {
  const auto density = read_grid<openvdb::FloatGrid>(volume.texel, "density");
  const auto albedo = read_grid<openvdb::Vec3SGrid>(volume.texel, "albedo");
  density->tree().voxelizeActiveTiles();
  const std::size_t count = static_cast<std::size_t>(volume.voxels.x) *
                            static_cast<std::size_t>(volume.voxels.y) *
                            static_cast<std::size_t>(volume.voxels.z);
  std::vector<Sum> sums(count);
  Sum all;
  auto colour = albedo->getConstAccessor();
  for (auto at = density->cbeginValueOn(); at; ++at) {
    const openvdb::Coord voxel = at.getCoord();
    sums[voxel_at(volume, density->indexToWorld(voxel))].add(colour.getValue(voxel), double{*at});
    all.add(colour.getValue(voxel), double{*at});
  }
  const glm::vec3 mean = all.mean_or(glm::vec3(0.0F));
  std::vector<glm::vec3> result;
  result.reserve(count);
  for (const Sum& sum : sums) result.push_back(sum.mean_or(mean));
  return result;
}

}  // namespace wold::landscape
