#include "blender/frame_data.h"

#include <bit>
#include <nlohmann/json.hpp>

#include "blender/placement.h"
#include "core/files.h"
#include "core/image.h"
#include "core/random.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using landscape::Landscape;

static_assert(std::endian::native == std::endian::little, "the arrays are written as they lie");

template <class T>
void write_array(const fs::path& path, const std::vector<T>& values) {
  write_file(path, std::string_view(reinterpret_cast<const char*>(values.data()),
                                    values.size() * sizeof(T)));
}

Json json_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Json camera_json(const landscape::Camera& camera) {
  return {{"eye_m", json_of(camera.eye_m)},
          {"target_m", json_of(camera.target_m)},
          {"field_of_view_deg", camera.field_of_view_deg}};
}

Json write_terrain(const Landscape& landscape, const fs::path& folder) {
  write_array(folder / "heights_m.f32", landscape.terrain.values());
  return {{"heights", "heights_m.f32"},
          {"samples", landscape.terrain.samples()},
          {"size_m", landscape.terrain.size_m()}};
}

/// North at the top: pictures begin with their upper row, ground maps with the southern one.
Image picture_of(const ColourMap& map) {
  Image picture(map.samples(), map.samples(), 3);
  for (int j = 0; j < map.samples(); ++j)
    for (int i = 0; i < map.samples(); ++i) {
      const glm::vec3& colour = map.at(i, j);
      std::copy_n(&colour.x, 3, picture.pixel(i, map.samples() - 1 - j));
    }
  return picture;
}

Json write_ground_map(const ColourMap& map, const fs::path& folder, const char* name) {
  write_image(folder / name, picture_of(map), PixelFormat::float32);
  return {{"file", name}, {"samples", map.samples()}, {"size_m", map.size_m()}};
}

void append(std::vector<float>& values, const glm::dvec3& v) {
  for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(v[axis]));
}

/// Moves a cell by up to 0.03 voxels, each by its own way. The volumes of neighbours overlap, and
/// on even ground their hulls would have faces in one plane; a ray that meets two faces at once
/// sees but one of them and loses the other volume: dark specks along the joints.
glm::dvec3 nudge(std::size_t cell, double voxel_m) {
  const auto part = [&](const char* axis) {
    return 2.0 * random_uniform({0, key_of("cell"), cell, key_of(axis)}) - 1.0;
  };
  return 0.03 * voxel_m * glm::dvec3(part("nudge x"), part("nudge y"), part("nudge z"));
}

Json write_cells(const Landscape& landscape, const fs::path& folder,
                 const std::vector<int>& picks) {
  std::vector<float> positions, first_turns, scales, second_turns;
  for (std::size_t i = 0; i < landscape.cells.size(); ++i) {
    const landscape::Cell& cell = landscape.cells[i];
    const landscape::Volume& volume = landscape.volumes[static_cast<std::size_t>(cell.volume)];
    const Placement placement = placement_of(cell.world_from_cell);
    append(positions, placement.position_m + nudge(i, volume.voxel_m));
    append(first_turns, placement.first_turn_rad);
    append(scales, placement.scale);
    append(second_turns, placement.second_turn_rad);
  }
  write_array(folder / "positions_m.f32", positions);
  write_array(folder / "first_turns_rad.f32", first_turns);
  write_array(folder / "scales.f32", scales);
  write_array(folder / "second_turns_rad.f32", second_turns);
  write_array(folder / "picks.i32", picks);
  return {{"count", picks.size()},
          {"positions", "positions_m.f32"},
          {"first_turns", "first_turns_rad.f32"},
          {"scales", "scales.f32"},
          {"second_turns", "second_turns_rad.f32"},
          {"picks", "picks.i32"}};
}

/// The size lets scene.py refuse a file that was cut short; Blender itself would crash.
Json volumes_json(const std::vector<VolumeEntry>& volumes, const fs::path& folder) {
  Json list = Json::array();
  for (const VolumeEntry& volume : volumes)
    list.push_back({{"file", volume.file.lexically_relative(folder).generic_string()},
                    {"bytes", fs::file_size(volume.file)},
                    {"step_voxels", volume.step_voxels}});
  return list;
}

}  // namespace

void write_frame_data(const Landscape& landscape, const fs::path& folder,
                      const std::vector<VolumeEntry>& volumes, const std::vector<int>& picks) {
  write_image(folder / "sky.exr", landscape.sky, PixelFormat::float32);
  const Json frame = {{"frame", landscape.frame},
                      {"weathering", landscape.weathering},
                      {"size_px", {landscape.width_px, landscape.height_px}},
                      {"samples", landscape.samples},
                      {"exposure_gain", landscape.exposure_gain},
                      {"camera", camera_json(landscape.camera)},
                      {"terrain", write_terrain(landscape, folder)},
                      {"light", write_ground_map(landscape.light, folder, "light.exr")},
                      {"ground", write_ground_map(landscape.ground, folder, "ground.exr")},
                      {"sky", "sky.exr"},
                      {"cells", write_cells(landscape, folder, picks)},
                      {"volumes", volumes_json(volumes, folder)}};
  write_file(folder / "frame.json", frame.dump(2) + "\n");
}

}  // namespace wold::blender
