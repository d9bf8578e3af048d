#include "blender/volume_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/vdb_file.h"
#include "landscape/cell_parts.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;

constexpr const char* content_key = "wold_content";

/// Changes whenever this file writes the same volume differently.
constexpr int layout = 5;

std::string content_of(const landscape::Volume& volume) {
  return fmt::format("{} {} {}", layout, volume.content, volume.emission_grid);
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

/// Up to the highest of the voxels that are there: Cycles keeps the whole box in memory. Index 1 is
/// the first voxel.
openvdb::CoordBBox without_air_above(const glm::ivec3& voxels, const openvdb::FloatGrid& density) {
  const openvdb::CoordBBox there = density.evalActiveVoxelBoundingBox();
  return {openvdb::Coord(1),
          openvdb::Coord(voxels.x, voxels.y, there.empty() ? 1 : there.max().z())};
}

/// From 1/m. What would be 1 or more, grass through which a millimetre lets no hundredth of the
/// light, becomes as good as 1.
void count_in_units(openvdb::FloatGrid& density) {
  constexpr float most = 0.999F;
  for (auto at = density.beginValueOn(); at; ++at)
    at.setValue(std::min(*at / density_unit_per_m, most));
}

/// density * radiance on the voxels of `density`.
openvdb::Vec3SGrid::Ptr emission_of(const openvdb::FloatGrid& density,
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
/// the border two neighbouring cells would both be there, twice as dense, where they overlap. With
/// it each fades over one voxel while the other comes up, and they add to what interpolating across
/// the joint gives. Two corners are enough, since Cycles fills the box of active voxels.
template <class Grid>
void add_border(Grid& grid, const openvdb::CoordBBox& voxels) {
  const typename Grid::ValueType nothing(0.0F);
  auto accessor = grid.getAccessor();
  accessor.setValueOn(voxels.min().offsetBy(-1), nothing);
  accessor.setValueOn(voxels.max().offsetBy(1), nothing);
}

void prepare(openvdb::GridBase& grid, const std::string& name, double voxel_m) {
  grid.clearMetadata();
  grid.setName(name);
  grid.setTransform(cycles_transform(voxel_m));
}

/// Density and what it emits, ready to be written.
openvdb::GridPtrVec medium_grids(const openvdb::FloatGrid::Ptr& density,
                                 const openvdb::Vec3SGrid::Ptr& emission,
                                 const openvdb::CoordBBox& voxels, double voxel_m) {
  const auto ready = [&](auto& grid, const char* name) {
    add_border(grid, voxels);
    prepare(grid, name, voxel_m);
    grid.setGridClass(openvdb::GRID_FOG_VOLUME);
    grid.setSaveFloatAsHalf(true);
  };
  ready(*density, "density");
  ready(*emission, "emission");
  return {density, emission};
}

/// Where there is any density, in leaves: constant ones are single values in `density`.
openvdb::MaskTree leaves_of(const openvdb::FloatGrid& density) {
  openvdb::MaskTree leaves(density.tree(), false, true, openvdb::TopologyCopy());
  leaves.voxelizeActiveTiles();
  return leaves;
}

/// Those of `leaves` that lie over a quarter. Two voxels of a leaf say so, not on its faces, since
/// Cycles makes every hull a voxel wider. Truth values and no mask: from Blender 5.0 on Cycles does
/// not know masks.
openvdb::BoolGrid::Ptr hull_of(const landscape::Part& quarter, const glm::ivec3& voxels,
                               const openvdb::MaskTree& leaves) {
  constexpr int side = openvdb::MaskTree::LeafNodeType::DIM;
  auto hull = openvdb::BoolGrid::create();
  for (auto leaf = leaves.cbeginLeaf(); leaf; ++leaf) {
    const openvdb::Coord first = leaf->origin();
    const glm::dvec2 middle =
        (glm::dvec2(first.x(), first.y()) + side / 2.0 - 1.0) / glm::dvec2(voxels);
    if (leaf->isEmpty() || glm::any(glm::lessThan(middle, quarter.low)) ||
        glm::any(glm::greaterThan(middle, quarter.high)))
      continue;
    for (const int inside : {1, side - 2}) hull->tree().setValueOn(first.offsetBy(inside), true);
  }
  return hull;
}

}  // namespace

void write_volume(const fs::path& path, const landscape::Volume& volume) {
  const std::string content = content_of(volume);
  if (is_there(path, content)) return;
  const auto density = read_grid<openvdb::FloatGrid>(volume.vdb, "density");
  const auto radiance = read_grid<openvdb::Vec3SGrid>(volume.vdb, volume.emission_grid);
  leave_out_empty_voxels(*density);
  count_in_units(*density);
  const openvdb::MaskTree leaves = leaves_of(*density);
  const openvdb::CoordBBox box = without_air_above(volume.voxels, *density);
  openvdb::GridPtrVec grids =
      medium_grids(density, emission_of(*density, *radiance), box, volume.voxel_m);
  int number = 0;
  for (const landscape::Part& quarter : landscape::quarters_of_patch(volume.voxels.x)) {
    const auto hull = hull_of(quarter, volume.voxels, leaves);
    prepare(*hull, fmt::format("quarter {}", number++), volume.voxel_m);
    grids.push_back(hull);
  }
  openvdb::MetaMap metadata;
  metadata.insertMeta(content_key, openvdb::StringMetadata(content));
  write_vdb(path, grids, metadata);
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
  write_vdb(path, medium_grids(density, emission, voxels, cloud.voxel_m));
}

}  // namespace wold::blender
