#include "usd/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/error.h"
#include "core/files.h"
#include "core/parallel.h"
#include "core/rough_picture.h"
#include "usd/blade_files.h"
#include "usd/frame_files.h"
#include "usd/frame_stage.h"
#include "usd/ground_file.h"
#include "usd/text.h"
#include "usd/volume_file.h"

namespace wold::usd {
namespace {

namespace fs = std::filesystem;
using landscape::Landscape;

/// The upper row is the northern one.
Image picture_of(const ColourMap& map) {
  const int n = map.samples();
  Image picture(n, n, 3);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) std::copy_n(&map.at(i, j).x, 3, picture.pixel(i, n - 1 - j));
  return picture;
}

std::vector<fs::path> write_all_blades(const Landscape& landscape, const fs::path& folder) {
  const std::vector<landscape::BladeMesh>& meshes = landscape.blade_meshes;
  if (!meshes.empty()) make_folder(folder);
  parallel_for(meshes.size(), [&](std::size_t i) { write_blades(meshes[i], folder); });
  std::vector<fs::path> files;
  for (const landscape::BladeMesh& mesh : meshes)
    for (const fs::path& file : blade_files(mesh, folder)) files.push_back(file);
  return files;
}

std::vector<fs::path> write_volumes(const Landscape& landscape, const fs::path& folder) {
  std::map<std::string, const landscape::Volume*> shown;
  for (const landscape::Cell& cell : landscape.cells) {
    const auto& volume = landscape.volumes.at(static_cast<std::size_t>(cell.volume));
    shown.emplace(volume_name(volume), &volume);
  }
  std::vector<const landscape::Volume*> volumes;
  std::vector<fs::path> files;
  for (const auto& [name, volume] : shown) {
    volumes.push_back(volume);
    files.push_back(folder / (name + ".vdb"));
  }
  if (!volumes.empty()) make_folder(folder);
  parallel_for(volumes.size(), [&](std::size_t i) { write_volume(*volumes[i], folder); });
  return files;
}

std::vector<fs::path> write_flake_pictures(const Landscape& landscape, const fs::path& folder) {
  if (landscape.flakes.flakes.empty()) return {};
  make_folder(folder);
  std::vector<fs::path> files;
  for (const landscape::FlakePicture& picture : landscape.flakes.pictures) {
    files.push_back(folder / (picture.name + ".png"));
    if (!fs::exists(files.back())) write_image(files.back(), picture.opacity, PixelFormat::uint8);
  }
  return files;
}

std::vector<fs::path> write_clouds(const Landscape& landscape, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const landscape::CloudBox& cloud : landscape.clouds) {
    files.push_back(folder / (cloud.name + ".vdb"));
    write_cloud(files.back(), cloud);
  }
  return files;
}

std::vector<fs::path> write_pictures(const Landscape& landscape, const fs::path& folder) {
  std::vector<fs::path> files;
  const auto named = [&](const std::string& name) {
    files.push_back(folder / name);
    return files.back();
  };
  write_image(named("sky.exr"), landscape.sky, PixelFormat::half);
  write_image(named("sky_without_sun.exr"), landscape.unlit->sky, PixelFormat::half);
  write_image(named("ground_albedo.exr"), picture_of(landscape.unlit->ground_albedo),
              PixelFormat::half);
  write_rough_picture(named("ground.exr"), picture_of(landscape.ground));
  for (std::size_t i = 0; i < landscape.ground_details.size(); ++i)
    write_rough_picture(named(detail_picture(i + 1)), picture_of(landscape.ground_details[i].map));
  if (landscape.backdrop)
    write_image(named("backdrop.exr"), landscape.backdrop->picture, PixelFormat::half);
  return files;
}

/// What the frame had in its folder and has no more.
void remove_others(const std::vector<fs::path>& files, const fs::path& folder) {
  const std::set<fs::path> wanted(files.begin(), files.end());
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(folder))
    if (!wanted.contains(entry.path())) others.push_back(entry.path());
  for (const fs::path& other : others) fs::remove(other);
}

}  // namespace

std::vector<fs::path> export_frame(const Landscape& landscape, const fs::path& folder) {
  if (!landscape.unlit)
    throw InputError("found a landscape of baked light alone, expected one with its materials");
  const fs::path of_frame = folder / frame_folder(landscape);
  make_folder(of_frame);
  std::vector<fs::path> files = write_pictures(landscape, of_frame);
  const auto add = [&](const std::vector<fs::path>& more) {
    files.insert(files.end(), more.begin(), more.end());
  };
  add(write_clouds(landscape, of_frame));
  remove_others(files, of_frame);
  add(write_all_blades(landscape, folder / blades_folder));
  add(write_volumes(landscape, folder / volumes_folder));
  add(write_flake_pictures(landscape, folder / flakes_folder));
  const std::string ground = write_ground(landscape, folder / "data");
  const fs::path layer = folder / frame_layer(landscape.frame);
  write_file(layer, frame_text(landscape, ground));
  add({folder / "data" / ground, layer});
  return files;
}

}  // namespace wold::usd
