#include "support/synthetic_landscape.h"

#include <fmt/format.h>

#include "core/files.h"
#include "core/random.h"
#include "core/vdb_file.h"

namespace wold::test {
namespace {

constexpr double patch_m = 0.5;

landscape::Volume write_volume(const SyntheticMeadow& meadow, int number,
                               const std::filesystem::path& folder) {
  const int n = meadow.voxels;
  const double voxel_m = patch_m / n;
  auto density = openvdb::FloatGrid::create(0.0F);
  auto emission = openvdb::Vec3SGrid::create(openvdb::Vec3s(0.0F));
  density->setName("density");
  emission->setName("emission_q0");
  auto transform = openvdb::math::Transform::createLinearTransform(voxel_m);
  transform->postTranslate(openvdb::Vec3d(-0.5 * voxel_m));
  density->setTransform(transform);
  emission->setTransform(transform->copy());
  density->setGridClass(openvdb::GRID_FOG_VOLUME);
  auto rho = density->getAccessor();
  auto light = emission->getAccessor();
  for (std::uint64_t blade = 0; blade < 150; ++blade) {
    const auto random = [&](const char* purpose) {
      return random_uniform(
          {static_cast<std::uint64_t>(number), key_of("blade"), blade, key_of(purpose)});
    };
    const glm::dvec2 root(random("x") * n, random("y") * n);
    const glm::dvec2 lean((random("lx") - 0.5) * 0.6, (random("ly") - 0.5) * 0.6);
    const double top = meadow.height_voxels * (0.5 + 0.5 * random("height"));
    for (double z = 0.5; z < top; z += 0.5) {
      const glm::dvec2 at = root + lean * z;
      const openvdb::Coord voxel(((static_cast<int>(std::floor(at.x)) % n) + n) % n + 1,
                                 ((static_cast<int>(std::floor(at.y)) % n) + n) % n + 1,
                                 static_cast<int>(z) + 1);
      const auto height = static_cast<float>(z / meadow.height_voxels);
      rho.setValue(voxel, static_cast<float>(0.6 / voxel_m));
      light.setValue(voxel, openvdb::Vec3s(0.03F, 0.10F, 0.015F) * (0.3F + height));
    }
  }
  landscape::Volume volume;
  volume.name = fmt::format("v{}_k00_q0_{}", number, n);
  volume.vdb = folder / (volume.name + ".vdb");
  volume.emission_grid = "emission_q0";
  volume.voxels = {n, n, meadow.height_voxels};
  volume.voxel_m = voxel_m;
  write_vdb(volume.vdb, {density, emission});
  volume.texel = folder / (volume.name + "_unlit.vdb");
  auto albedo = emission->deepCopy();
  albedo->setName("albedo");
  write_vdb(volume.texel, {density, albedo});
  volume.content = content_hash(read_file(volume.vdb));
  return volume;
}

glm::dmat4 sheared_cell(const Heightfield& terrain, int i, int j) {
  const double x = i * patch_m;
  const double y = j * patch_m;
  const double mid = patch_m / 2;
  const double dx = (terrain.sample(x + patch_m, y + mid) - terrain.sample(x, y + mid)) / patch_m;
  const double dy = (terrain.sample(x + mid, y + patch_m) - terrain.sample(x + mid, y)) / patch_m;
  const double z = terrain.sample(x + mid, y + mid) - (dx + dy) * mid;
  return glm::dmat4({1, 0, dx, 0}, {0, 1, dy, 0}, {0, 0, 1, 0}, {x, y, z, 1});
}

}  // namespace

landscape::BladeMesh pillar(const char* name, double width_m, double height_m,
                            const glm::vec3& radiance) {
  auto tubes = std::make_shared<Tubes>();
  tubes->rings = 2;
  tubes->corners = 4;
  const auto half = static_cast<float>(width_m / 2.0);
  const auto middle = static_cast<float>(patch_m / 2.0);
  for (const float z : {0.0F, static_cast<float>(height_m)})
    for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      tubes->vertices_m.emplace_back(middle + half * corner, z);
  tubes->radiance.assign(2, radiance);
  tubes->reflectance.assign(2, glm::vec3(0.1F, 0.3F, 0.05F));
  tubes->transmittance.assign(2, glm::vec3(0.05F, 0.2F, 0.02F));
  return {name, tubes};
}

landscape::Landscape synthetic_landscape(const SyntheticMeadow& meadow,
                                         const std::filesystem::path& folder) {
  landscape::Landscape scene;
  make_folder(folder);
  const double size_m = meadow.cells_per_side * patch_m;
  const int samples = meadow.cells_per_side * 4 + 1;
  scene.terrain = Heightfield(samples, size_m);
  scene.light = ColourMap(samples, size_m);
  scene.ground = ColourMap(samples, size_m);
  scene.extinction_factor = FactorMap(samples, size_m, 1.0F);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const double x = i * scene.terrain.step_m();
      const double y = j * scene.terrain.step_m();
      scene.terrain.at(i, j) = static_cast<float>(meadow.slope * y + 0.05 * std::sin(2.0 * x));
      const float shade = 0.8F + 0.2F * static_cast<float>(std::cos(x));
      scene.light.at(i, j) = glm::vec3(shade, shade, 0.9F);
      scene.ground.at(i, j) = glm::vec3(0.02F, 0.015F, 0.009F) * shade;
    }
  for (int number = 0; number < meadow.volumes; ++number)
    scene.volumes.push_back(write_volume(meadow, number, folder));
  for (int j = 0; j < meadow.cells_per_side; ++j)
    for (int i = 0; i < meadow.cells_per_side; ++i)
      scene.cells.push_back({sheared_cell(scene.terrain, i, j), (i + 2 * j) % meadow.volumes});
  scene.blade_meshes = {pillar("pillar", 0.1, 0.3, {0.05F, 0.1F, 0.02F})};
  scene.blade_cells = {{scene.cells.back().world_from_cell, 0}};
  scene.cells.pop_back();
  scene.patch_m = patch_m;
  scene.sky = Image(64, 32, 3);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      const float zenith = std::max(0.0F, 1.0F - static_cast<float>(y) / 16.0F);
      float* pixel = scene.sky.pixel(x, y);
      pixel[0] = 0.09F - 0.06F * zenith;
      pixel[1] = 0.10F - 0.04F * zenith;
      pixel[2] = 0.11F + 0.02F * zenith;
    }
  scene.unlit = landscape::Unlit{glm::vec3(1.4F, 1.1F, 0.7F), scene.sky,
                                 ColourMap(samples, size_m, glm::vec3(0.2F, 0.15F, 0.1F))};
  scene.camera.eye_m = {size_m / 2, -0.6, 0.7};
  scene.camera.target_m = {size_m / 2, size_m * 0.6, 0.15};
  scene.camera.field_of_view_deg = 50.0;
  scene.width_px = meadow.width_px;
  scene.height_px = meadow.height_px;
  scene.samples = 8;
  scene.exposure_gain = 4.0;
  return scene;
}

}  // namespace wold::test
