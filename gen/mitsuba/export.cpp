#include "mitsuba/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/error.h"
#include "core/files.h"
#include "core/parallel.h"
#include "mitsuba/grid_file.h"
#include "mitsuba/leaf_files.h"
#include "mitsuba/ply_file.h"
#include "mitsuba/scene_file.h"
#include "mitsuba/texel_files.h"

namespace wold::mitsuba {
namespace {

namespace fs = std::filesystem;
using landscape::Landscape;

/// The ground's triangles in world space; its picture has the north at the top.
Mesh ground_mesh(const Heightfield& terrain) {
  const int n = terrain.samples();
  const auto index = [n](int i, int j) { return static_cast<std::uint32_t>(j * n + i); };
  Mesh mesh;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      mesh.vertices.push_back({glm::vec3(terrain.place_m(i, j), terrain.at(i, j)),
                               glm::vec2(i, n - 1 - j) / static_cast<float>(n - 1)});
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i)
      mesh.add_quad({index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
  return mesh;
}

/// From their origin, with the ground's picture.
Mesh boulder_mesh(const Landscape& landscape) {
  const Heightfield& terrain = landscape.terrain;
  const landscape::RaisedGround& boulders = landscape.boulders;
  Mesh mesh;
  for (const glm::vec3& from_origin_m : boulders.points_m) {
    const glm::dvec3 at_m = boulders.origin_m + glm::dvec3(from_origin_m);
    const glm::dvec2 place = (glm::dvec2(at_m) - terrain.corner_m()) / terrain.size_m();
    mesh.vertices.push_back({from_origin_m, glm::vec2(place.x, 1.0 - place.y)});
  }
  for (const glm::uvec3& corners : boulders.triangles)
    mesh.triangles.push_back({corners.x, corners.y, corners.z});
  return mesh;
}

/// Returns the file's name, which says what is in it.
std::string write_mesh(const Mesh& mesh, const char* stem, const fs::path& folder) {
  const std::string bytes = ply_bytes(mesh);
  std::string name = fmt::format("{}_{}.ply", stem, content_hash(bytes));
  update_file(folder / name, bytes);
  return name;
}

/// The upper row is the northern one.
Image picture_of(const ColourMap& map) {
  const int n = map.samples();
  Image picture(n, n, 3);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) std::copy_n(&map.at(i, j).x, 3, picture.pixel(i, n - 1 - j));
  return picture;
}

/// Removes the grids of clouds that the frame had and has no more.
void remove_other_clouds(const Landscape& landscape, const fs::path& frame_folder) {
  std::set<fs::path> wanted;
  for (const landscape::CloudBox* cloud : shown_clouds(landscape))
    wanted.insert(cloud_file(*cloud));
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(frame_folder))
    if (entry.path().extension() == ".vol" && !wanted.contains(entry.path().filename()))
      others.push_back(entry.path());
  for (const fs::path& other : others) fs::remove(other);
}

/// One of the volumes of each name that cells show.
std::map<std::string, const landscape::Volume*> shown_texels(const Landscape& landscape) {
  std::map<std::string, const landscape::Volume*> shown;
  for (const landscape::Cell& cell : landscape.cells) {
    const landscape::Volume& volume = landscape.volumes.at(static_cast<std::size_t>(cell.volume));
    shown.emplace(texel_name(volume), &volume);
  }
  return shown;
}

std::vector<fs::path> write_texels(const Landscape& landscape, const fs::path& folder) {
  const auto shown = shown_texels(landscape);
  if (shown.empty()) return {};
  make_folder(folder);
  std::vector<const landscape::Volume*> volumes;
  std::vector<fs::path> files;
  for (const auto& [name, volume] : shown) {
    volumes.push_back(volume);
    for (const fs::path& file : texel_files(name, folder)) files.push_back(file);
  }
  parallel_for(volumes.size(), [&](std::size_t i) { write_texel(*volumes[i], folder); });
  return files;
}

std::vector<fs::path> write_all_leaves(const Landscape& landscape, const fs::path& folder) {
  const std::vector<landscape::BladeMesh>& meshes = landscape.blade_meshes;
  if (meshes.empty()) return {};
  make_folder(folder);
  parallel_for(meshes.size(), [&](std::size_t i) { write_leaves(meshes[i], folder); });
  std::vector<fs::path> files;
  for (const landscape::BladeMesh& mesh : meshes)
    for (const fs::path& file : leaf_files(mesh.name, folder)) files.push_back(file);
  return files;
}

std::vector<fs::path> write_clouds(const Landscape& landscape, const fs::path& frame_folder) {
  std::vector<fs::path> files;
  for (const landscape::CloudBox* cloud : shown_clouds(landscape)) {
    files.push_back(frame_folder / cloud_file(*cloud));
    write_file(files.back(), grid_bytes(cloud->voxels, cloud->extinction_per_m));
  }
  remove_other_clouds(landscape, frame_folder);
  return files;
}

}  // namespace

std::vector<fs::path> export_frame(const Landscape& landscape, const fs::path& folder) {
  if (!landscape.unlit)
    throw InputError("found a landscape of baked light alone, expected one with its materials");
  const fs::path data = folder / "data";
  const fs::path frame_folder = data / fmt::format("frame_{:04}", landscape.frame);
  make_folder(frame_folder);
  std::vector<fs::path> files = write_all_leaves(landscape, data / "leaves");
  for (const fs::path& file : write_texels(landscape, data / "texels")) files.push_back(file);
  for (const fs::path& file : write_clouds(landscape, frame_folder)) files.push_back(file);
  const std::string terrain = write_mesh(ground_mesh(landscape.terrain), "terrain", data);
  const bool has_boulders = !landscape.boulders.triangles.empty();
  const std::string boulders =
      has_boulders ? write_mesh(boulder_mesh(landscape), "boulders", data) : "";
  write_image(frame_folder / "sky.exr", landscape.unlit->sky, PixelFormat::half);
  write_image(frame_folder / "ground.exr", picture_of(landscape.unlit->ground_albedo),
              PixelFormat::half);
  write_file(frame_folder / "scene.xml", scene_text(landscape, terrain, boulders));
  files.insert(files.end(), {data / terrain, frame_folder / "sky.exr", frame_folder / "ground.exr",
                             frame_folder / "scene.xml"});
  if (has_boulders) files.push_back(data / boulders);
  return files;
}

}  // namespace wold::mitsuba
