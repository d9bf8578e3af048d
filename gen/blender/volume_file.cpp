#include "blender/volume_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "core/error.h"
#include "core/vdb_file.h"
#include "landscape/cell_parts.h"
#include "landscape/vdb_medium.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;

constexpr const char* content_key = "wold_content";

/// Of a volume's extinction, what leave_out_tips() may leave out.
constexpr double fraction_of_tips = 0.0005;

/// Changes whenever this file writes the same volume differently.
constexpr int layout = 6;

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

/// Up to version 4.5 Cycles holds voxel i to be the box from i to i + 1, its value in the middle,
/// where OpenVDB's own convention puts the value at i. Index 1 is our first voxel, so index space
/// starts one whole voxel below the cell and not half of one.
openvdb::math::Transform::Ptr cycles_transform(double voxel_m) {
  auto transform = openvdb::math::Transform::createLinearTransform(voxel_m);
  transform->postTranslate(openvdb::Vec3d(-voxel_m));
  return transform;
}

/// The highest layers, which have `fraction` of the extinction at most: the tips of a blade or two.
/// Without them the box of voxels is lower by a sixth. Some renderers keep all of it in memory.
void leave_out_tips(openvdb::FloatGrid& density, double fraction) {
  density.tree().voxelizeActiveTiles();
  std::map<int, double> layers;
  double all = 0.0;
  for (auto at = density.cbeginValueOn(); at; ++at) {
    layers[at.getCoord().z()] += double{*at};
    all += double{*at};
  }
  double left = fraction * all;
  auto lowest_tips = layers.end();
  while (lowest_tips != layers.begin() && std::prev(lowest_tips)->second <= left)
    left -= (--lowest_tips)->second;
  if (lowest_tips == layers.end()) return;
  for (auto at = density.beginValueOn(); at; ++at)
    if (at.getCoord().z() >= lowest_tips->first) at.setValue(0.0F);
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
  constexpr float max = 0.999F;
  for (auto at = density.beginValueOn(); at; ++at)
    at.setValue(std::min(*at / density_unit_per_m, max));
}

/// What a ray's radiance gains, a grid for each colour: a vector would take the memory of four
/// numbers in some renderers, and cannot be had in half precision.
using Emission = std::array<openvdb::FloatGrid::Ptr, 3>;

constexpr std::array<const char*, 3> emission_names = {"emission red", "emission green",
                                                       "emission blue"};

/// density * radiance on the voxels of `density`.
Emission emission_of(const openvdb::FloatGrid& density, const openvdb::Vec3SGrid& radiance) {
  Emission emission;
  for (std::size_t colour = 0; colour < emission.size(); ++colour) {
    emission[colour] = density.deepCopy();
    auto source = radiance.getConstAccessor();
    for (auto at = emission[colour]->beginValueOn(); at; ++at)
      at.setValue(*at * source.getValue(at.getCoord())[static_cast<int>(colour)]);
  }
  return emission;
}

/// A border of zeros, one voxel wide. Cycles repeats a grid's outermost values beyond it: without
/// the border two neighbouring cells would both be there, twice as dense, where they overlap. With
/// it each fades over one voxel while the other comes up, and they add to what interpolating across
/// the joint gives. Two corners are enough, since Cycles fills the box of active voxels.
void add_border(openvdb::FloatGrid& grid, const openvdb::CoordBBox& voxels) {
  auto accessor = grid.getAccessor();
  accessor.setValueOn(voxels.min().offsetBy(-1), 0.0F);
  accessor.setValueOn(voxels.max().offsetBy(1), 0.0F);
}

void prepare(openvdb::GridBase& grid, const std::string& name, double voxel_m) {
  grid.clearMetadata();
  grid.setName(name);
  grid.setTransform(cycles_transform(voxel_m));
}

/// Density and what it emits, ready to be written.
openvdb::GridPtrVec medium_grids(const openvdb::FloatGrid::Ptr& density, const Emission& emission,
                                 const openvdb::CoordBBox& voxels, double voxel_m) {
  openvdb::GridPtrVec grids;
  const auto add = [&](const openvdb::FloatGrid::Ptr& grid, const char* name) {
    add_border(*grid, voxels);
    prepare(*grid, name, voxel_m);
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    grid->setSaveFloatAsHalf(true);
    grids.push_back(grid);
  };
  add(density, "density");
  for (std::size_t colour = 0; colour < emission.size(); ++colour)
    add(emission[colour], emission_names[colour]);
  return grids;
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
  const auto density = read_vdb_grid_as<openvdb::FloatGrid>(volume.vdb, "density");
  const auto radiance = read_vdb_grid_as<openvdb::Vec3SGrid>(volume.vdb, volume.emission_grid);
  leave_out_tips(*density, fraction_of_tips);
  landscape::leave_out_empty_voxels(*density);
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
  const landscape::CloudGrids grids = landscape::cloud_grids(cloud);
  const openvdb::CoordBBox voxels(openvdb::Coord(1), openvdb::Coord(&cloud.voxels.x));
  write_vdb(path, medium_grids(grids.extinction, emission_of(*grids.extinction, *grids.radiance),
                               voxels, cloud.voxel_m));
}

}  // namespace wold::blender
