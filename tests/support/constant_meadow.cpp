#include "support/constant_meadow.h"

#include <algorithm>

#include "core/files.h"
#include "core/vdb.h"
#include "core/vdb_file.h"
#include "support/synthetic_landscape.h"

namespace wold::test {
namespace {

constexpr double patch_m = 0.5;

landscape::Volume constant_volume(const ConstantMeadow& meadow,
                                  const std::filesystem::path& folder) {
  auto density = openvdb::FloatGrid::create(0.0F);
  auto emission = openvdb::Vec3SGrid::create(openvdb::Vec3s(0.0F));
  density->setName("density");
  emission->setName("emission_q0");
  const openvdb::CoordBBox box(
      openvdb::Coord(1),
      openvdb::Coord(meadow.voxels - meadow.bare_voxels, meadow.voxels, meadow.height_voxels));
  density->fill(box, meadow.extinction);
  emission->fill(box, openvdb::Vec3s(meadow.radiance));
  landscape::Volume volume;
  volume.name = "fog";
  volume.vdb = folder / "fog.vdb";
  volume.emission_grid = "emission_q0";
  volume.voxels = {meadow.voxels, meadow.voxels, meadow.height_voxels};
  volume.voxel_m = patch_m / meadow.voxels;
  write_vdb(volume.vdb, {density, emission});
  volume.texel = folder / "fog_unlit.vdb";
  auto albedo = emission->deepCopy();
  albedo->setName("albedo");
  write_vdb(volume.texel, {density, albedo});
  volume.content = content_hash(read_file(volume.vdb));
  return volume;
}

}  // namespace

landscape::Landscape constant_meadow(const ConstantMeadow& meadow,
                                     const std::filesystem::path& folder) {
  SyntheticMeadow shape;
  shape.cells_per_side = meadow.cells_per_side;
  shape.voxels = 2;
  shape.height_voxels = 1;
  shape.volumes = 1;
  shape.slope = meadow.slope;
  shape.width_px = meadow.width_px;
  shape.height_px = meadow.height_px;
  landscape::Landscape scene = synthetic_landscape(shape, folder);
  scene.volumes = {constant_volume(meadow, folder)};
  std::fill(scene.light.values().begin(), scene.light.values().end(), glm::vec3(1.0F));
  std::fill(scene.ground.values().begin(), scene.ground.values().end(), glm::vec3(meadow.ground));
  std::fill(scene.sky.values.begin(), scene.sky.values.end(), meadow.sky);
  scene.samples = 1;
  return scene;
}

}  // namespace wold::test
