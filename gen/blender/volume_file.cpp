#include "blender/volume_file.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/vdb_file.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;

constexpr const char* content_key = "wold_content";

/// Changes whenever this file writes the same volume differently.
constexpr int layout = 3;

std::string content_of(const landscape::Volume& volume, const landscape::Part& part) {
  return fmt::format("{} {} {}{}", layout, volume.content, volume.emission_grid, suffix_of(part));
}

bool is_there(const fs::path& path, const std::string& content) {
  if (!fs::exists(path)) return false;
  try {
    const auto metadata = read_vdb_metadata(path);
    const auto found = metadata->getMetadata<openvdb::StringMetadata>(content_key);
    return found && found->value() == content;
  } catch (const FileError&) {
    return false;  // damaged: written anew
  }
}

template <class Grid>
typename Grid::Ptr read_grid(const fs::path& path, const std::string& name) {
  auto grid = openvdb::gridPtrCast<Grid>(read_vdb_grid(path, name));
  if (!grid)
    throw FileError(fmt::format("{}: grid \"{}\" has an unexpected type", path.string(), name));
  return grid;
}

/// Up to version 4.5 Cycles holds voxel i to be the box from i to i + 1, its value in the middle,
/// where OpenVDB's own convention puts the value at i. Index 1 is our first voxel, so index space
/// starts one whole voxel below the cell and not half of one.
openvdb::math::Transform::Ptr cycles_transform(double voxel_m) {
  auto transform = openvdb::math::Transform::createLinearTransform(voxel_m);
  transform->postTranslate(openvdb::Vec3d(-voxel_m));
  return transform;
}

/// In one thread: OpenVDB's foreach shares a leaf between threads, whose voxels' states share
/// words.
void leave_out_empty_voxels(openvdb::FloatGrid& density) {
  for (auto at = density.beginValueOn(); at; ++at)
    if (!(*at > 0.0F)) at.setValueOff();
  density.pruneGrid();
}

/// Index 1 is the first voxel.
openvdb::CoordBBox voxels_of(const landscape::Volume& volume, const landscape::Part& part) {
  const auto before = [&](const glm::dvec2& share) {
    return glm::ivec2(glm::round(share * glm::dvec2(volume.voxels)));
  };
  const glm::ivec2 low = before(part.low), high = before(part.high);
  return {openvdb::Coord(low.x + 1, low.y + 1, 1), openvdb::Coord(high.x, high.y, volume.voxels.z)};
}

/// Up to the highest of the voxels that are there: Cycles keeps the whole box in memory.
openvdb::CoordBBox without_air_above(const openvdb::CoordBBox& voxels,
                                     const openvdb::FloatGrid& density) {
  const openvdb::CoordBBox there = density.evalActiveVoxelBoundingBox();
  openvdb::Coord highest = voxels.max();
  highest.z() = there.empty() ? voxels.min().z() : there.max().z();
  return {voxels.min(), highest};
}

openvdb::FloatGrid::Ptr cut_out(const openvdb::FloatGrid& density,
                                const openvdb::CoordBBox& voxels) {
  auto part = density.deepCopy();
  part->tree().clip(voxels);
  return part;
}

/// density * radiance on the voxels of `density`.
openvdb::Vec3SGrid::Ptr emission_per_metre(const openvdb::FloatGrid& density,
                                           const openvdb::Vec3SGrid& radiance) {
  const openvdb::Vec3s dark(0.0F);
  auto tree = std::make_shared<openvdb::Vec3STree>(density.tree(), dark, openvdb::TopologyCopy());
  auto emission = openvdb::Vec3SGrid::create(tree);
  auto rho = density.getConstAccessor();
  auto source = radiance.getConstAccessor();
  for (auto at = emission->beginValueOn(); at; ++at) {
    const openvdb::Coord voxel = at.getCoord();
    at.setValue(rho.getValue(voxel) * source.getValue(voxel));
  }
  return emission;
}

/// A border of zeros, one voxel wide. Cycles repeats a grid's outermost values beyond it: without
/// the border two neighbours would both be there, twice as dense, where they overlap. With it each
/// fades over one voxel while the other comes up, and they add to what interpolating across the
/// joint gives. Two corners are enough, since Cycles fills the box of active voxels.
template <class Grid>
void add_border(Grid& grid, const openvdb::CoordBBox& voxels) {
  const typename Grid::ValueType nothing(0.0F);
  auto accessor = grid.getAccessor();
  accessor.setValueOn(voxels.min().offsetBy(-1), nothing);
  accessor.setValueOn(voxels.max().offsetBy(1), nothing);
}

template <class Grid>
void prepare(Grid& grid, const char* name, const openvdb::CoordBBox& voxels, double voxel_m) {
  add_border(grid, voxels);
  grid.clearMetadata();
  grid.setName(name);
  grid.setTransform(cycles_transform(voxel_m));
  grid.setGridClass(openvdb::GRID_FOG_VOLUME);
  grid.setSaveFloatAsHalf(true);
}

void write_grids(const fs::path& path, const openvdb::FloatGrid::Ptr& density,
                 const openvdb::Vec3SGrid::Ptr& emission, const openvdb::CoordBBox& voxels,
                 double voxel_m, const openvdb::MetaMap& metadata) {
  prepare(*density, "density", voxels, voxel_m);
  prepare(*emission, "emission", voxels, voxel_m);
  write_vdb(path, {density, emission}, metadata);
}

}  // namespace

fs::path volume_file(const fs::path& folder, const landscape::Volume& volume,
                     const landscape::Part& part) {
  return folder / (volume.name + suffix_of(part) + ".vdb");
}

void write_volume(const fs::path& folder, const landscape::Volume& volume,
                  const std::vector<landscape::Part>& parts) {
  std::vector<landscape::Part> missing;
  for (const landscape::Part& part : parts)
    if (!is_there(volume_file(folder, volume, part), content_of(volume, part)))
      missing.push_back(part);
  if (missing.empty()) return;
  auto whole = read_grid<openvdb::FloatGrid>(volume.vdb, "density");
  const auto radiance = read_grid<openvdb::Vec3SGrid>(volume.vdb, volume.emission_grid);
  leave_out_empty_voxels(*whole);
  for (const landscape::Part& part : missing) {
    const openvdb::CoordBBox columns = voxels_of(volume, part);
    const auto density = cut_out(*whole, columns);
    const openvdb::CoordBBox voxels = without_air_above(columns, *density);
    openvdb::MetaMap metadata;
    metadata.insertMeta(content_key, openvdb::StringMetadata(content_of(volume, part)));
    write_grids(volume_file(folder, volume, part), density, emission_per_metre(*density, *radiance),
                voxels, volume.voxel_m, metadata);
  }
}

void write_cloud(const fs::path& path, const landscape::CloudBox& cloud) {
  auto density = openvdb::FloatGrid::create(0.0F);
  auto emission = openvdb::Vec3SGrid::create(openvdb::Vec3s(0.0F));
  auto rho = density->getAccessor();
  auto glow = emission->getAccessor();
  std::size_t i = 0;
  for (int z = 1; z <= cloud.voxels.z; ++z)
    for (int y = 1; y <= cloud.voxels.y; ++y)
      for (int x = 1; x <= cloud.voxels.x; ++x, ++i) {
        const float extinction = cloud.extinction_per_m[i];
        if (!(extinction > 0.0F)) continue;
        const glm::vec3 gain = extinction * cloud.radiance[i];
        rho.setValue(openvdb::Coord(x, y, z), extinction);
        glow.setValue(openvdb::Coord(x, y, z), openvdb::Vec3s(gain.x, gain.y, gain.z));
      }
  const openvdb::CoordBBox voxels(openvdb::Coord(1), openvdb::Coord(&cloud.voxels.x));
  write_grids(path, density, emission, voxels, cloud.voxel_m, {});
}

}  // namespace wold::blender
