#include "blender/frame_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "blender/arrays.h"
#include "blender/placement.h"
#include "blender/shown_volumes.h"
#include "blender/volume_file.h"
#include "core/files.h"
#include "core/image.h"
#include "core/random.h"
#include "core/rough_picture.h"
#include "landscape/light_on_grass.h"

namespace wold::blender {
namespace {

/// Of the folder; templates/blender/wold_blender/frame_data.py reads no other.
constexpr int format = 7, format_with_boulders = 8, format_with_light_details = 9;

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using landscape::Landscape;

int format_of(const Landscape& landscape) {
  if (!landscape.light_details.empty()) return format_with_light_details;
  return landscape.boulders.triangles.empty() ? format : format_with_boulders;
}

Json json_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Json camera_json(const landscape::Camera& camera) {
  return {{"eye_m", json_of(camera.eye_m)},
          {"target_m", json_of(camera.target_m)},
          {"field_of_view_deg", camera.field_of_view_deg}};
}

Json daylight_json(const landscape::Daylight& daylight) {
  return {{"to_sun", json_of(daylight.to_sun)},
          {"sun_irradiance", json_of(daylight.sun_irradiance)},
          {"sky_irradiance", json_of(daylight.sky_irradiance)}};
}

Json write_terrain(const Landscape& landscape, const fs::path& folder) {
  write_array(folder / "heights_m.f32", landscape.terrain.values());
  return {{"heights", "heights_m.f32"},
          {"samples", landscape.terrain.samples()},
          {"size_m", landscape.terrain.size_m()}};
}

/// Corners of triangles, which a frame without boulders does not have.
Json write_boulders(const landscape::RaisedGround& boulders, const fs::path& folder) {
  write_array(folder / "boulders_m.f32", boulders.points_m);
  write_array(folder / "boulders.u32", boulders.triangles);
  return {{"points", "boulders_m.f32"},
          {"origin_m", json_of(boulders.origin_m)},
          {"point_count", boulders.points_m.size()},
          {"triangles", "boulders.u32"},
          {"triangle_count", boulders.triangles.size()}};
}

/// North at the top: pictures begin with their upper row, ground maps with the southern one. A
/// fourth channel, if any, is on the same grid.
Image picture_of(const ColourMap& map, const FactorMap* fourth) {
  const int channels = fourth != nullptr ? 4 : 3;
  Image picture(map.samples(), map.samples(), channels);
  for (int j = 0; j < map.samples(); ++j)
    for (int i = 0; i < map.samples(); ++i) {
      float* pixel = picture.pixel(i, map.samples() - 1 - j);
      std::copy_n(&map.at(i, j).x, 3, pixel);
      if (fourth != nullptr) pixel[3] = fourth->at(i, j);
    }
  return picture;
}

Json map_json(const ColourMap& map, const char* name) {
  Json json = {{"file", name}, {"samples", map.samples()}, {"size_m", map.size_m()}};
  if (map.corner_m() != glm::dvec2(0.0)) json["corner_m"] = {map.corner_m().x, map.corner_m().y};
  return json;
}

/// What multiplies grass: smooth, and dark where there is none.
Json write_light_map(const ColourMap& light, const fs::path& folder, const char* name,
                     const FactorMap* fourth = nullptr) {
  write_image(folder / name, picture_of(light, fourth), PixelFormat::half);
  return map_json(light, name);
}

Json write_ground_map(const ColourMap& ground, const fs::path& folder, const char* name,
                      const FactorMap* fourth = nullptr) {
  write_rough_picture(folder / name, picture_of(ground, fourth));
  return map_json(ground, name);
}

/// How much of a finer picture of the ground is seen: none along its edge, all inside its border.
FactorMap fading_in(const landscape::GroundDetail& detail, double border_m) {
  const ColourMap& map = detail.map;
  FactorMap seen(map.samples(), map.size_m());
  const int last = map.samples() - 1;
  for (int j = 0; j <= last; ++j)
    for (int i = 0; i <= last; ++i) {
      const int from_edge = std::min({i, j, last - i, last - j});
      seen.at(i, j) = static_cast<float>(std::min(1.0, from_edge * map.step_m() / border_m));
    }
  return seen;
}

/// Finer pictures of the ground, coarse to fine, with how much of them is seen as fourth channel.
Json write_ground_details(const Landscape& landscape, const fs::path& folder) {
  const auto name = [](std::size_t number) { return fmt::format("ground_detail_{}.exr", number); };
  const std::size_t count = landscape.ground_details.size();
  for (std::size_t stale = count + 1; fs::remove(folder / name(stale));) ++stale;
  Json list = Json::array();
  const ColourMap* coarser = &landscape.ground;
  for (std::size_t i = 0; i < count; ++i) {
    const landscape::GroundDetail& detail = landscape.ground_details[i];
    const FactorMap seen = fading_in(detail, soft_border_m(*coarser, detail));
    list.push_back(write_ground_map(detail.map, folder, name(i + 1).c_str(), &seen));
    list.back()["corner_m"] = {detail.corner_m.x, detail.corner_m.y};
    coarser = &detail.map;
  }
  return list;
}

/// The light on the volumes with how much of them stands as its fourth channel: one look-up.
Json write_standing_light(const Landscape& landscape, const fs::path& folder, int number,
                          const char* name) {
  const FactorMap standing = landscape::standing_fraction(landscape, number);
  const ColourMap light = product(landscape::light_map(landscape, number), standing);
  return write_light_map(light, folder, name, &standing);
}

/// The finer maps of the light on volumes and, where there are any, on blades, coarse to fine.
Json write_light_details(const Landscape& landscape, const fs::path& folder) {
  const auto light = [](int number) { return fmt::format("light_{}.exr", number); };
  const auto standing = [](int number) { return fmt::format("standing_light_{}.exr", number); };
  const int count = landscape::count_light_maps(landscape);
  for (int stale = count; fs::exists(folder / standing(stale)); ++stale) {
    fs::remove(folder / light(stale));
    fs::remove(folder / standing(stale));
  }
  Json list = Json::array();
  for (int number = 1; number < count; ++number) {
    const std::string standing_name = standing(number), light_name = light(number);
    Json& detail = list.emplace_back();
    detail["standing_light"] =
        write_standing_light(landscape, folder, number, standing_name.c_str());
    if (landscape.blade_meshes.empty())
      fs::remove(folder / light_name);
    else
      detail["light"] =
          write_light_map(landscape::light_map(landscape, number), folder, light_name.c_str());
  }
  return list;
}

/// Null under a clear sky.
Json write_backdrop(const Landscape& landscape, const fs::path& folder) {
  constexpr const char* name = "backdrop.exr";
  if (!landscape.backdrop) {
    fs::remove(folder / name);
    return nullptr;
  }
  const landscape::Backdrop& backdrop = *landscape.backdrop;
  write_image(folder / name, backdrop.picture, PixelFormat::half);
  return {{"file", name},
          {"corner_m", json_of(backdrop.corner_m)},
          {"right_m", json_of(backdrop.right_m)},
          {"up_m", json_of(backdrop.up_m)}};
}

Json write_clouds(const Landscape& landscape, const fs::path& folder) {
  Json list = Json::array();
  for (const landscape::CloudBox& cloud : landscape.clouds) {
    const std::string name = cloud.name + ".vdb";
    write_cloud(folder / name, cloud);
    list.push_back({{"file", name},
                    {"bytes", fs::file_size(folder / name)},
                    {"voxel_m", cloud.voxel_m},
                    {"is_haze", cloud.is_haze},
                    {"corner_m", json_of(cloud.corner_m)}});
  }
  return list;
}

/// A list with `value(flake)` of each flake.
template <class Value>
auto of_each(const std::vector<landscape::Flake>& flakes, const Value& value) {
  std::vector<decltype(value(flakes.front()))> values;
  values.reserve(flakes.size());
  for (const landscape::Flake& flake : flakes) values.push_back(value(flake));
  return values;
}

Json write_flake_pictures(const std::vector<landscape::FlakePicture>& pictures,
                          const fs::path& pictures_folder, const fs::path& folder) {
  make_folder(pictures_folder);
  Json list = Json::array();
  for (const landscape::FlakePicture& picture : pictures) {
    const fs::path path = pictures_folder / (picture.name + ".png");
    if (!fs::exists(path)) write_image(path, picture.opacity, PixelFormat::uint8);
    list.push_back(path.lexically_relative(folder).generic_string());
  }
  return list;
}

/// Null without any.
Json write_flakes(const Landscape& landscape, const fs::path& folder,
                  const fs::path& pictures_folder) {
  using landscape::Flake;
  const landscape::Flakes& flakes = landscape.flakes;
  if (flakes.flakes.empty()) {
    for (const char* name : {"flake_corners_m.f32", "flake_pictures.i32", "flake_opacities.f32"})
      fs::remove(folder / name);
    return nullptr;
  }
  const glm::dvec3& eye_m = landscape.camera.eye_m;
  write_array(folder / "flake_corners_m.f32", of_each(flakes.flakes, [&](const Flake& flake) {
                return corners_from(eye_m, flake);
              }));
  write_array(folder / "flake_pictures.i32",
              of_each(flakes.flakes, [](const Flake& flake) { return flake.picture; }));
  write_array(folder / "flake_opacities.f32",
              of_each(flakes.flakes, [](const Flake& flake) { return flake.opacity; }));
  return {{"count", flakes.flakes.size()},
          {"corners", "flake_corners_m.f32"},
          {"picks", "flake_pictures.i32"},
          {"opacities", "flake_opacities.f32"},
          {"pictures", write_flake_pictures(flakes.pictures, pictures_folder, folder)},
          {"radiance", json_of(flakes.radiance)}};
}

/// Null without any.
Json fog_json(const std::optional<landscape::Fog>& fog) {
  if (!fog) return nullptr;
  return {{"extinction_per_m", fog->extinction_per_m}, {"radiance", json_of(fog->radiance)}};
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

/// Writes the arrays of instances as <prefix><array>.
Json write_instances(const std::vector<Placement>& placements, const std::vector<int>& picks,
                     const fs::path& folder, const std::string& prefix) {
  std::vector<float> positions, first_turns, scales, second_turns;
  for (const Placement& placement : placements) {
    append(positions, placement.position_m);
    append(first_turns, placement.first_turn_rad);
    append(scales, placement.scale);
    append(second_turns, placement.second_turn_rad);
  }
  const auto written = [&](const char* name, const auto& values) {
    write_array(folder / (prefix + name), values);
    return prefix + name;
  };
  return {{"count", picks.size()},
          {"positions", written("positions_m.f32", positions)},
          {"first_turns", written("first_turns_rad.f32", first_turns)},
          {"scales", written("scales.f32", scales)},
          {"second_turns", written("second_turns_rad.f32", second_turns)},
          {"picks", written("picks.i32", picks)}};
}

/// A part along one axis, from low to high, in metres. One on a side of its patch reaches beyond:
/// there the volume fades and its neighbour comes up.
glm::dvec2 shown_m(double low, double high, double patch_m) {
  return patch_m * glm::dvec2(low > 0.0 ? low : -1.0, high < 1.0 ? high : 2.0);
}

/// Writes which part of its cell each shows, and names the arrays in `cells`.
void write_parts(const Landscape& landscape, const fs::path& folder, Json& cells) {
  std::vector<float> middles_m, halves_m;
  for (const landscape::Cell& cell : landscape.cells) {
    const glm::dvec2 x_m = shown_m(cell.part.low.x, cell.part.high.x, landscape.patch_m);
    const glm::dvec2 y_m = shown_m(cell.part.low.y, cell.part.high.y, landscape.patch_m);
    append(middles_m, {(x_m[0] + x_m[1]) / 2.0, (y_m[0] + y_m[1]) / 2.0, 0.0});
    append(halves_m, {(x_m[1] - x_m[0]) / 2.0, (y_m[1] - y_m[0]) / 2.0, 0.0});
  }
  cells["part_middles"] = "part_middles_m.f32";
  cells["part_halves"] = "part_halves_m.f32";
  write_array(folder / "part_middles_m.f32", middles_m);
  write_array(folder / "part_halves_m.f32", halves_m);
}

Json write_cells(const Landscape& landscape, const fs::path& folder,
                 const std::vector<int>& picks) {
  std::vector<Placement> placements;
  for (std::size_t i = 0; i < landscape.cells.size(); ++i) {
    const landscape::Cell& cell = landscape.cells[i];
    const landscape::Volume& volume = landscape.volumes[static_cast<std::size_t>(cell.volume)];
    placements.push_back(placement_of(cell.world_from_cell * cell.reach));
    placements.back().position_m += nudge(i, volume.voxel_m);
  }
  Json cells = write_instances(placements, picks, folder, "");
  write_parts(landscape, folder, cells);
  return cells;
}

Json write_blade_cells(const Landscape& landscape, const fs::path& folder,
                       const std::vector<int>& picks) {
  std::vector<Placement> placements;
  for (const landscape::BladeCell& cell : landscape.blade_cells)
    placements.push_back(placement_of(cell.world_from_cell));
  return write_instances(placements, picks, folder, "blade_");
}

Json colours_json(const VolumeEntry& volume, const fs::path& folder) {
  const fs::path file = colour_file(volume.file);
  return {{"file", file.lexically_relative(folder).generic_string()},
          {"bytes", fs::file_size(file)},
          {"side", volume.colours.side},
          {"slices", volume.colours.slices},
          {"scale", volume.colours.scale}};
}

/// The size lets a file that was cut short be refused; Blender itself would crash.
Json volumes_json(const std::vector<VolumeEntry>& volumes, const fs::path& folder) {
  Json list = Json::array();
  for (const VolumeEntry& volume : volumes)
    list.push_back({{"file", volume.file.lexically_relative(folder).generic_string()},
                    {"bytes", fs::file_size(volume.file)},
                    {"colours", colours_json(volume, folder)},
                    {"voxel_m", volume.voxel_m},
                    {"step_voxels", volume.step_voxels},
                    {"quarter", volume.quarter ? Json(*volume.quarter) : Json(nullptr)},
                    {"light_map", volume.light_map}});
  return list;
}

Json blades_json(const Landscape& landscape, const std::vector<ShownBlades>& shown,
                 const fs::path& blades, const fs::path& folder) {
  Json list = Json::array();
  for (const ShownBlades& each : shown) {
    const landscape::BladeMesh& mesh = landscape.blade_meshes[each.mesh];
    list.push_back({{"file", (blades / mesh.name).lexically_relative(folder).generic_string()},
                    {"vertices", mesh.tubes->vertices_m.size()},
                    {"quads", quad_corners(*mesh.tubes).size() / 4},
                    {"light_map", each.light_map}});
  }
  return list;
}

/// What lies in the folder itself of what the frame names.
void append_named_files(const Json& json, const fs::path& folder, std::vector<fs::path>& files) {
  for (const Json& value : json) {
    if (value.is_structured()) append_named_files(value, folder, files);
    if (!value.is_string()) continue;
    const fs::path name = value.get<std::string>();
    if (!name.has_parent_path()) files.push_back(folder / name);
  }
}

}  // namespace

std::vector<fs::path> write_frame_data(const Landscape& landscape, const fs::path& folder,
                                       const std::vector<VolumeEntry>& volumes,
                                       const std::vector<int>& picks,
                                       const fs::path& shared_folder) {
  write_image(folder / "sky.exr", landscape.sky, PixelFormat::half);
  const bool has_boulders = !landscape.boulders.triangles.empty();
  const ShownInstances<ShownBlades> blades = shown_blades(landscape);
  Json frame = {
      {"format", format_of(landscape)},
      {"frame", landscape.frame},
      {"weathering", landscape.weathering},
      {"time_s", landscape.time_s},
      {"daylight", daylight_json(landscape.daylight)},
      {"size_px", {landscape.width_px, landscape.height_px}},
      {"samples", landscape.samples},
      {"exposure_gain", landscape.exposure_gain},
      {"camera", camera_json(landscape.camera)},
      {"terrain", write_terrain(landscape, folder)},
      {"light", write_light_map(landscape.light, folder, "light.exr")},
      {"standing_light", write_standing_light(landscape, folder, 0, "standing_light.exr")},
      {"light_details", write_light_details(landscape, folder)},
      {"ground", write_ground_map(landscape.ground, folder, "ground.exr")},
      {"ground_details", write_ground_details(landscape, folder)},
      {"sky", "sky.exr"},
      {"clouds", write_clouds(landscape, folder)},
      {"backdrop", write_backdrop(landscape, folder)},
      {"cells", write_cells(landscape, folder, picks)},
      {"volumes", volumes_json(volumes, folder)},
      {"density_unit_per_m", density_unit_per_m},
      {"blade_cells", write_blade_cells(landscape, folder, blades.picks())},
      {"blades", blades_json(landscape, blades.all(), shared_folder / "blades", folder)},
      {"flakes", write_flakes(landscape, folder, shared_folder / "flakes")},
      {"fog", fog_json(landscape.fog)}};
  if (has_boulders) frame["boulders"] = write_boulders(landscape.boulders, folder);
  write_file(folder / "frame.json", frame.dump(2) + "\n");
  std::vector<fs::path> files = {folder / "frame.json"};
  append_named_files(frame, folder, files);
  return files;
}

}  // namespace wold::blender
