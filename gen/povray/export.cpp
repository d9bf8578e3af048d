#include "povray/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <string>

#include "core/files.h"
#include "core/parallel.h"
#include "expectation/expectation.h"
#include "landscape/light_on_grass.h"
#include "povray/blade_files.h"
#include "povray/flake_files.h"
#include "povray/ground_files.h"
#include "povray/settings.h"
#include "povray/text.h"
#include "povray/volume_files.h"

namespace wold::povray {
namespace fs = std::filesystem;
namespace {

/// Numbers the volumes that cells use, in the landscape's order: landscape index -> index here.
std::map<int, int> used_volumes(const landscape::Landscape& scene) {
  std::map<int, int> used;
  for (const landscape::Cell& cell : scene.cells) used[cell.volume] = 0;
  int next = 0;
  for (auto& [from, to] : used) to = next++;
  return used;
}

/// Volumes that share their extinction, by its name.
using Texels = std::map<std::string, std::vector<const landscape::Volume*>>;

Texels texels_of(const landscape::Landscape& scene, const std::map<int, int>& used) {
  Texels texels;
  for (const auto& [from, to] : used) {
    const landscape::Volume& volume = scene.volumes[static_cast<std::size_t>(from)];
    texels[density_name(volume)].push_back(&volume);
  }
  return texels;
}

void write_volumes(const Texels& texels, int bits, const fs::path& folder) {
  std::vector<const std::vector<const landscape::Volume*>*> todo;
  for (const auto& [name, volumes] : texels) todo.push_back(&volumes);
  parallel_for(todo.size(), [&](std::size_t i) { write_texel(*todo[i], bits, folder); });
}

/// What is said of the map in the files `name`.df3 or `name`_r.df3 and so on: place and scale.
template <class Map, class Scale>
std::string map_text(const char* name, const Map& map, const Scale& scale) {
  return fmt::format(
      "#declare Wold_{0}_samples = {1};  // per side\n"
      "#declare Wold_{0}_step_m = {2};\n"
      "#declare Wold_{0}_corner_m = {3};\n"
      "#declare Wold_{0}_max = {4};  // of the largest numbers in its files\n",
      name, map.samples(), number(map.step_m()), vector(glm::dvec3(map.corner_m(), 0.0)), scale);
}

/// Where the maps after the first are.
std::string light_details_text(const std::vector<ColourMap>& maps) {
  if (maps.size() < 2) return {};
  std::string text = fmt::format("#declare Wold_light_detail = array[{}][4] {{\n", maps.size() - 1);
  for (std::size_t i = 1; i < maps.size(); ++i)
    text += fmt::format("  {{ {}, {}, {}, {} }},\n", number(maps[i].corner_m().x),
                        number(maps[i].corner_m().y), maps[i].samples(), number(maps[i].step_m()));
  return text + "}  // finer light, coarse to fine: west and south edge, samples, step: metres\n";
}

/// Writes the maps that multiply the grass and says so: extinction and light of the volumes, and,
/// where there are any, the light on blades, which stand or do not, on the same squares.
std::string write_grass_maps(const landscape::Landscape& scene, const fs::path& folder) {
  const auto each = [&](const auto& map) {
    std::vector<ColourMap> maps;
    for (int number = 0; number < landscape::count_light_maps(scene); ++number)
      maps.push_back(continued(map(scene, number)));
    return maps;
  };
  const auto light_text = [&](const char* name, const std::vector<ColourMap>& maps) {
    return map_text(name, maps.front(), vector(write_light(maps, folder, name)));
  };
  const FactorMap extinction_factor = continued(scene.extinction_factor);
  std::string text = map_text("standing", extinction_factor,
                              number(write_factor(extinction_factor, folder / "standing.df3")));
  const std::vector<ColourMap> standing = each(landscape::standing_light);
  text += light_text("light", standing) + light_details_text(standing);
  if (scene.blade_meshes.empty())
    remove_light(folder, "blade_light", 0);
  else
    text += light_text("blade_light", each(landscape::light_map));
  return text;
}

/// Writes the backdrop's picture, if there is one, and where it stands.
std::string write_backdrop(const std::optional<landscape::Backdrop>& backdrop,
                           const fs::path& folder) {
  const fs::path path = folder / "backdrop.exr";
  if (!backdrop) {
    fs::remove(path);
    return {};
  }
  write_image(path, backdrop->picture, PixelFormat::half);
  return fmt::format(
      "#declare Wold_backdrop_corner_m = {};\n"
      "#declare Wold_backdrop_right_m = {};\n"
      "#declare Wold_backdrop_up_m = {};\n",
      vector(backdrop->corner_m), vector(backdrop->right_m), vector(backdrop->up_m));
}

std::string air_text(const landscape::Landscape& scene) {
  std::string text;
  if (!scene.flakes.flakes.empty())
    text += fmt::format("#declare Wold_flake_radiance = {};\n", vector(scene.flakes.radiance));
  if (scene.fog)
    text += fmt::format(
        "#declare Wold_fog_extinction_per_m = {};\n"
        "#declare Wold_fog_radiance = {};\n",
        number(scene.fog->extinction_per_m), vector(scene.fog->radiance));
  return text;
}

/// Samples of a cloud along a ray. There is haze between grass and between flakes, where a ray has
/// many parts, each with as many samples.
constexpr int cloud_intervals = 250, haze_intervals = 64;

std::string clouds_text(const std::vector<landscape::CloudBox>& clouds) {
  std::string text;
  for (const landscape::CloudBox& cloud : clouds)
    text += fmt::format("Wold_cloud({}, {}, {})\n", literal(cloud.name), vector(cloud.corner_m),
                        cloud.is_haze ? haze_intervals : cloud_intervals);
  return include_file(text);
}

/// `terrain` and `boulders`: names of files; there may be no boulders.
std::string frame_text(const landscape::Landscape& scene, const std::string& terrain,
                       const std::string& boulders) {
  std::string text = fmt::format(
      "// Frame {}, weathering degree {}. Metres; x east, y north, z up.\n"
      "#declare Wold_eye_m = {};\n"
      "#declare Wold_target_m = {};\n"
      "#declare Wold_field_of_view_deg = {};  // horizontal\n"
      "#declare Wold_exposure_gain = {};\n"
      "#declare Wold_to_sun = {};\n"
      "#declare Wold_sun_irradiance = {};  // of what faces it\n"
      "#declare Wold_sky_irradiance = {};  // of level ground\n"
      "#declare Wold_patch_m = {};\n"
      "#declare Wold_ground_samples = {};\n"
      "#declare Wold_ground_step_m = {};\n"
      "#declare Wold_terrain_file = {};\n",
      scene.frame, number(scene.weathering), vector(scene.camera.eye_m),
      vector(scene.camera.target_m), number(scene.camera.field_of_view_deg),
      number(scene.exposure_gain), vector(scene.daylight.to_sun),
      vector(scene.daylight.sun_irradiance), vector(scene.daylight.sky_irradiance),
      number(scene.patch_m), scene.ground.samples(), number(scene.ground.step_m()),
      literal(terrain));
  if (!boulders.empty())
    text += fmt::format(
        "#declare Wold_boulders_file = {};\n"
        "#declare Wold_boulders_origin_m = {};\n",
        literal(boulders), vector(scene.boulders.origin_m));
  return text;
}

void write_volumes_list(std::ostream& out, const landscape::Landscape& scene,
                        const std::map<int, int>& used) {
  const Texels texels = texels_of(scene, used);
  out << include_begin << fmt::format("Wold_volumes({}, {})\n", texels.size(), used.size());
  std::map<std::string, std::size_t> numbers;
  for (const auto& [name, volumes] : texels) {
    const std::size_t number = numbers.size();
    numbers[name] = number;
    out << fmt::format("Wold_grass_density({}, {})\n", number, literal(name));
  }
  for (const auto& [from, to] : used) {
    const landscape::Volume& volume = scene.volumes[static_cast<std::size_t>(from)];
    out << fmt::format("Wold_volume({}, {}, {})\n", to, literal(volume.name),
                       numbers.at(density_name(volume)));
  }
  out << fmt::format("Wold_meshes({})\n", scene.blade_meshes.size());
  for (std::size_t i = 0; i < scene.blade_meshes.size(); ++i)
    out << fmt::format("Wold_blades({}, {})\n", i, literal(scene.blade_meshes[i].name));
  out << include_end;
}

/// The columns of world_from_cell, which are where x, y and z of the cell go, and its corner.
std::string place_text(const glm::dmat4& world_from_cell) {
  const auto column = [&](int c) { return vector(glm::dvec3(world_from_cell[c])); };
  return fmt::format("{}, {}, {}, {}", column(0), column(1), column(2), column(3));
}

/// What Wold_cells() of the scene program reads: numbers and vectors, each with a comma after it.
void write_cells(std::ostream& out, const landscape::Landscape& scene,
                 const std::map<int, int>& used) {
  out << fmt::format("{},\n", scene.cells.size());
  for (const landscape::Cell& cell : scene.cells)
    out << fmt::format("{}, {}, {}, {}, {},\n", used.at(cell.volume),
                       landscape::light_map_of(scene, cell.world_from_cell),
                       place_text(cell.world_from_cell), vector(glm::dvec3(cell.part.low, 0.0)),
                       vector(glm::dvec3(cell.part.high, 0.0)));
  out << fmt::format("{},\n", scene.blade_cells.size());
  for (const landscape::BladeCell& cell : scene.blade_cells)
    out << fmt::format("{}, {}, {},\n", cell.mesh,
                       landscape::light_map_of(scene, cell.world_from_cell),
                       place_text(cell.world_from_cell));
}

/// The frame's own files.
std::vector<fs::path> frame_files(const landscape::Landscape& scene, const fs::path& frame) {
  std::vector<std::string> names = {"frame.inc", "cells.txt",  "volumes.inc",  "clouds.inc",
                                    "sky.exr",   "ground.exr", "standing.df3", "expected.json"};
  for (int number = 0; number < landscape::count_light_maps(scene); ++number) {
    std::ranges::copy(light_files("light", static_cast<std::size_t>(number)),
                      std::back_inserter(names));
    if (!scene.blade_meshes.empty())
      std::ranges::copy(light_files("blade_light", static_cast<std::size_t>(number)),
                        std::back_inserter(names));
  }
  if (scene.backdrop) names.emplace_back("backdrop.exr");
  if (!scene.flakes.flakes.empty()) names.emplace_back("flakes.inc");
  for (std::size_t i = 1; i <= scene.ground_details.size(); ++i)
    names.push_back(fmt::format("ground_detail_{}.exr", i));
  std::vector<fs::path> files;
  files.reserve(names.size());
  for (const std::string& name : names) files.push_back(frame / name);
  for (const landscape::CloudBox& cloud : scene.clouds)
    for (const fs::path& file : cloud_files(cloud, frame)) files.push_back(file);
  return files;
}

/// What frames share, in `data`, as far as this one needs it.
std::vector<fs::path> shared_files(const landscape::Landscape& scene,
                                   const std::map<int, int>& used, const fs::path& data) {
  std::set<fs::path> volumes;
  for (const auto& [from, to] : used)
    for (const fs::path& file :
         volume_files(scene.volumes[static_cast<std::size_t>(from)], data / "volumes"))
      volumes.insert(file);
  std::vector<fs::path> files(volumes.begin(), volumes.end());
  for (const landscape::BladeMesh& mesh : scene.blade_meshes)
    for (const char* extension : {".inc", ".exr"})
      files.push_back(data / "blades" / (mesh.name + extension));
  if (!scene.flakes.flakes.empty())
    for (const landscape::FlakePicture& picture : scene.flakes.pictures)
      files.push_back(data / "flakes" / (picture.name + ".png"));
  return files;
}

}  // namespace

std::vector<fs::path> export_frame(const landscape::Landscape& scene, const fs::path& folder,
                                   int df3_bits) {
  const fs::path data = folder / "data";
  const fs::path frame = data / fmt::format("frame_{:04}", scene.frame);
  make_folder(frame);
  const std::map<int, int> used = used_volumes(scene);
  write_volumes(texels_of(scene, used), df3_bits, data / "volumes");
  if (!scene.blade_meshes.empty()) make_folder(data / "blades");
  for (const landscape::BladeMesh& mesh : scene.blade_meshes) write_blades(mesh, data / "blades");
  const std::string terrain = write_terrain(scene.terrain, data);
  const bool has_boulders = !scene.boulders.triangles.empty();
  const std::string boulders = has_boulders ? write_boulders(scene.boulders, data) : "";
  const std::string maps = write_grass_maps(scene, frame);
  const std::string backdrop = write_backdrop(scene.backdrop, frame);
  write_map_picture(scene.ground, frame / "ground.exr");
  const std::string details = write_ground_details(scene, frame);
  write_image(frame / "sky.exr", scene.sky, PixelFormat::half);
  fs::remove(frame / "cells.inc");  // of versions before cells.txt: require_data_only() refuses it
  write_file(frame / "cells.txt", [&](std::ostream& out) { write_cells(out, scene, used); });
  write_file(frame / "volumes.inc",
             [&](std::ostream& out) { write_volumes_list(out, scene, used); });
  for (const landscape::CloudBox& cloud : scene.clouds) write_cloud(cloud, df3_bits, frame);
  write_file(frame / "clouds.inc", clouds_text(scene.clouds));
  write_flakes(scene.flakes, scene.camera.eye_m, frame, data / "flakes");
  write_file(frame / "frame.inc", include_file(frame_text(scene, terrain, boulders) + maps +
                                               details + backdrop + air_text(scene)));
  write_expected_picture(frame / "expected.json", expectation::expected_picture(scene));
  const fs::path frame_ini = data / fmt::format("frame_{:04}.ini", scene.frame);
  const glm::ivec2 size_px = {scene.width_px, scene.height_px};
  write_file(frame_ini, frame_settings(size_px, scene.samples, scene.frame));
  export_settings(size_px, scene.samples, folder);
  std::vector<fs::path> files = frame_files(scene, frame);
  for (const fs::path& shared : shared_files(scene, used, data)) files.push_back(shared);
  files.insert(files.end(), {data / terrain, frame_ini, folder / "povray.ini"});
  if (has_boulders) files.push_back(data / boulders);
  return files;
}

void export_settings(glm::ivec2 size_px, int samples, const fs::path& folder) {
  update_file(folder / "povray.ini", settings(size_px, samples));
}

void export_scene(std::span<const FrameMoment> film, const fs::path& folder) {
  make_folder(folder);
  write_frame_index(film, folder);
  for (const auto& entry : fs::directory_iterator(shipped_file("templates/povray"))) {
    const fs::path& file = entry.path();
    if (file.extension() == ".pov" || file.extension() == ".inc")
      update_file(folder / file.filename(), read_file(file));
  }
}

}  // namespace wold::povray
