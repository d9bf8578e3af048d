#include "blender/volume_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

#include "core/colour.h"
#include "core/files.h"
#include "core/image.h"
#include "core/vdb_dense.h"
#include "core/vdb_file.h"
#include "landscape/cell_parts.h"
#include "landscape/emitted_light.h"
#include "landscape/vdb_medium.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;

constexpr const char* content_key = "wold_content";
constexpr const char* colours_key = "wold_colours";  ///< hash of the picture

/// Of a volume's extinction, what leave_out_tips() may leave out.
constexpr double fraction_of_tips = 0.0005;

/// Changes whenever this file writes the same volume differently.
constexpr int layout = 7;

std::string content_of(const landscape::Volume& volume) {
  return fmt::format("{} {} {}", layout, volume.content, volume.emission_grid);
}

std::string hash_of(const fs::path& path) { return content_hash(read_file(path)); }

/// How the colours lie that belong to a file of this content; none when one of the two is missing
/// or damaged.
std::optional<ColourPicture> colours_there(const fs::path& path, const std::string& content) {
  if (!fs::exists(path) || !fs::exists(colour_file(path))) return std::nullopt;
  try {
    const auto metadata = read_vdb_metadata(path);
    if (metadata->metaValue<std::string>(content_key) != content ||
        metadata->metaValue<std::string>(colours_key) != hash_of(colour_file(path)))
      return std::nullopt;
    return ColourPicture{metadata->metaValue<std::int32_t>("wold_colour_side"),
                         metadata->metaValue<std::int32_t>("wold_colour_slices"),
                         metadata->metaValue<float>("wold_colour_scale")};
  } catch (const std::exception&) {
    return std::nullopt;  // damaged: written anew
  }
}

openvdb::MetaMap metadata_of(const std::string& content, const fs::path& path,
                             const ColourPicture& colours) {
  openvdb::MetaMap metadata;
  metadata.insertMeta(content_key, openvdb::StringMetadata(content));
  metadata.insertMeta(colours_key, openvdb::StringMetadata(hash_of(colour_file(path))));
  metadata.insertMeta("wold_colour_side", openvdb::Int32Metadata(colours.side));
  metadata.insertMeta("wold_colour_slices", openvdb::Int32Metadata(colours.slices));
  metadata.insertMeta("wold_colour_scale", openvdb::FloatMetadata(colours.scale));
  return metadata;
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

/// What a ray's radiance gains, by name.
struct Emission {
  const char* name;
  openvdb::FloatGrid::Ptr grid;
};

/// density * value(radiance) on the voxels of `density`.
template <class Value>
openvdb::FloatGrid::Ptr emission_of(const openvdb::FloatGrid& density,
                                    const openvdb::Vec3SGrid& radiance, const Value& value) {
  const openvdb::FloatGrid::Ptr emission = density.deepCopy();
  auto source = radiance.getConstAccessor();
  for (auto at = emission->beginValueOn(); at; ++at)
    at.setValue(*at * value(source.getValue(at.getCoord())));
  return emission;
}

Emission luminance_of(const openvdb::FloatGrid& density, const openvdb::Vec3SGrid& radiance) {
  return {"emission", emission_of(density, radiance, [](const openvdb::Vec3s& colour) {
            return static_cast<float>(luminance({colour.x(), colour.y(), colour.z()}));
          })};
}

std::vector<Emission> channels_of(const openvdb::FloatGrid& density,
                                  const openvdb::Vec3SGrid& radiance) {
  std::vector<Emission> channels;
  for (const char* name : {"emission red", "emission green", "emission blue"}) {
    const auto channel = static_cast<int>(channels.size());
    channels.push_back({name, emission_of(density, radiance, [&](const openvdb::Vec3s& colour) {
                          return colour[channel];
                        })});
  }
  return channels;
}

/// The colours of a volume as high as a box of its voxels.
landscape::ColourGrid colours_in(const landscape::Volume& volume,
                                 const openvdb::CoordBBox& voxels) {
  const glm::ivec3 first(1);
  const glm::ivec3 size(volume.voxels.x, volume.voxels.y, voxels.max().z());
  return landscape::emitted_light(read_dense_floats(volume.vdb, "density", first, size),
                                  read_dense_vectors(volume.vdb, volume.emission_grid, first, size),
                                  size)
      .colours;
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
openvdb::GridPtrVec medium_grids(const openvdb::FloatGrid::Ptr& density,
                                 const std::vector<Emission>& emission,
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
  for (const Emission& each : emission) add(each.grid, each.name);
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

fs::path colour_file(const fs::path& volume_file) {
  return fs::path(volume_file).replace_extension(".png");
}

ColourPicture write_volume(const fs::path& path, const landscape::Volume& volume) {
  const std::string content = content_of(volume);
  if (const auto there = colours_there(path, content)) return *there;
  const auto density = read_vdb_grid_as<openvdb::FloatGrid>(volume.vdb, "density");
  const auto radiance = read_vdb_grid_as<openvdb::Vec3SGrid>(volume.vdb, volume.emission_grid);
  leave_out_tips(*density, fraction_of_tips);
  landscape::leave_out_empty_voxels(*density);
  count_in_units(*density);
  const openvdb::MaskTree leaves = leaves_of(*density);
  const openvdb::CoordBBox box = without_air_above(volume.voxels, *density);
  openvdb::GridPtrVec grids =
      medium_grids(density, {luminance_of(*density, *radiance)}, box, volume.voxel_m);
  int number = 0;
  for (const landscape::Part& quarter : landscape::quarters_of_patch(volume.voxels.x)) {
    const auto hull = hull_of(quarter, volume.voxels, leaves);
    prepare(*hull, fmt::format("quarter {}", number++), volume.voxel_m);
    grids.push_back(hull);
  }
  const landscape::ColourGrid colours = colours_in(volume, box);
  const ColourPicture picture = colour_picture_of(colours);
  write_image(colour_file(path), pixels_of(picture, colours), PixelFormat::uint8);
  write_vdb(path, grids, metadata_of(content, path, picture));
  return picture;
}

void write_cloud(const fs::path& path, const landscape::CloudBox& cloud) {
  const landscape::CloudGrids grids = landscape::cloud_grids(cloud);
  const openvdb::CoordBBox voxels(openvdb::Coord(1), openvdb::Coord(&cloud.voxels.x));
  write_vdb(path, medium_grids(grids.extinction, channels_of(*grids.extinction, *grids.radiance),
                               voxels, cloud.voxel_m));
}

}  // namespace wold::blender
