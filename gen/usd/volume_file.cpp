#include "usd/volume_file.h"

#include <fmt/format.h>

#include "core/vdb_file.h"
#include "landscape/vdb_medium.h"

namespace wold::usd {
namespace {

namespace fs = std::filesystem;

openvdb::Vec3SGrid::Ptr emission_of(const openvdb::FloatGrid& density,
                                    const openvdb::Vec3SGrid& radiance) {
  auto emission = openvdb::Vec3SGrid::create(openvdb::Vec3s(0.0F));
  emission->topologyUnion(density);
  auto source = radiance.getConstAccessor();
  auto extinction = density.getConstAccessor();
  for (auto at = emission->beginValueOn(); at; ++at)
    at.setValue(extinction.getValue(at.getCoord()) * source.getValue(at.getCoord()));
  return emission;
}

/// Index (1, 1, 1) is the first voxel; OpenVDB's values lie at whole indices.
openvdb::math::Transform::Ptr cell_transform(double voxel_m) {
  auto transform = openvdb::math::Transform::createLinearTransform(voxel_m);
  transform->postTranslate(openvdb::Vec3d(-0.5 * voxel_m));
  return transform;
}

void prepare(openvdb::GridBase& grid, const char* name, double voxel_m) {
  grid.clearMetadata();
  grid.setName(name);
  grid.setTransform(cell_transform(voxel_m));
  grid.setGridClass(openvdb::GRID_FOG_VOLUME);
}

void write_medium(const fs::path& path, const openvdb::FloatGrid::Ptr& density,
                  const openvdb::Vec3SGrid& radiance, double voxel_m) {
  landscape::leave_out_empty_voxels(*density);
  const auto emission = emission_of(*density, radiance);
  prepare(*density, "density", voxel_m);
  prepare(*emission, "emission", voxel_m);
  density->setSaveFloatAsHalf(true);
  emission->setSaveFloatAsHalf(true);
  write_vdb(path, {density, emission});
}

}  // namespace

std::string volume_name(const landscape::Volume& volume) {
  return fmt::format("{}_{}_{}", volume.vdb.stem().string(), volume.emission_grid, volume.content);
}

void write_volume(const landscape::Volume& volume, const fs::path& folder) {
  const fs::path path = folder / (volume_name(volume) + ".vdb");
  if (fs::exists(path)) return;
  const auto density = read_vdb_grid_as<openvdb::FloatGrid>(volume.vdb, "density");
  const auto radiance = read_vdb_grid_as<openvdb::Vec3SGrid>(volume.vdb, volume.emission_grid);
  write_medium(path, density, *radiance, volume.voxel_m);
}

void write_cloud(const fs::path& path, const landscape::CloudBox& cloud) {
  const landscape::CloudGrids grids = landscape::cloud_grids(cloud);
  write_medium(path, grids.extinction, *grids.radiance, cloud.voxel_m);
}

}  // namespace wold::usd
