#include "blender/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "blender/blade_files.h"
#include "blender/frame_data.h"
#include "blender/shown_volumes.h"
#include "blender/volume_file.h"
#include "core/files.h"
#include "core/parallel.h"
#include "core/pinhole.h"
#include "expectation/expectation.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;
using landscape::Landscape;

/// Shortest and longest step in voxels; beyond about two and a half the grass turns to noise.
constexpr double shortest_step_voxels = 1.5;
constexpr double longest_step_voxels = 2.5;

/// Distance in metres from the camera to the nearest cell of each volume; infinite for volumes
/// that no cell uses.
std::vector<double> nearest_m(const Landscape& landscape) {
  std::vector<double> nearest(landscape.volumes.size(), std::numeric_limits<double>::infinity());
  const glm::dvec4 middle(0.5 * landscape.patch_m, 0.5 * landscape.patch_m, 0.0, 1.0);
  for (const landscape::Cell& cell : landscape.cells) {
    double& distance = nearest.at(static_cast<std::size_t>(cell.volume));
    const glm::dvec3 place(cell.world_from_cell * middle);
    distance = std::min(distance, glm::distance(place, landscape.camera.eye_m));
  }
  return nearest;
}

/// A step may be half as long again as a pixel is wide where the volume is nearest to the camera.
double step_voxels(const Landscape& landscape, double voxel_m, double distance_m) {
  const double half_m = half_width(landscape.camera.field_of_view_deg) * distance_m;
  const double pixel_m = 2.0 * half_m / landscape.width_px;
  return std::clamp(1.5 * pixel_m / voxel_m, shortest_step_voxels, longest_step_voxels);
}

/// What frames share, in `data`, as far as this one needs it.
std::vector<fs::path> shared_files(const Landscape& landscape,
                                   const std::vector<VolumeEntry>& volumes, const fs::path& data) {
  std::set<fs::path> of_volumes;
  for (const VolumeEntry& volume : volumes)
    of_volumes.insert({volume.file, colour_file(volume.file)});
  std::vector<fs::path> files(of_volumes.begin(), of_volumes.end());
  for (const landscape::BladeMesh& mesh : landscape.blade_meshes)
    for (const fs::path& file : blade_files(mesh.name, data / "blades")) files.push_back(file);
  if (!landscape.flakes.flakes.empty())
    for (const landscape::FlakePicture& picture : landscape.flakes.pictures)
      files.push_back(data / "flakes" / (picture.name + ".png"));
  return files;
}

/// Writes the volumes that are shown; entries in order of their numbers.
std::vector<VolumeEntry> write_volumes(const Landscape& landscape,
                                       const std::vector<ShownVolume>& shown,
                                       const fs::path& folder) {
  const std::vector<double> distances_m = nearest_m(landscape);
  const auto file_of = [&](std::size_t volume) {
    return folder / (landscape.volumes[volume].name + ".vdb");
  };
  std::set<std::size_t> used;
  for (const ShownVolume& each : shown) used.insert(each.volume);
  const std::vector<std::size_t> todo(used.begin(), used.end());
  std::vector<ColourPicture> colours(landscape.volumes.size());
  parallel_for(todo.size(), [&](std::size_t i) {
    colours[todo[i]] = write_volume(file_of(todo[i]), landscape.volumes[todo[i]]);
  });
  std::vector<VolumeEntry> entries;
  for (const ShownVolume& each : shown) {
    const double voxel_m = landscape.volumes[each.volume].voxel_m;
    entries.push_back({file_of(each.volume), colours[each.volume], voxel_m,
                       step_voxels(landscape, voxel_m, distances_m[each.volume]), each.quarter,
                       each.light_map});
  }
  return entries;
}

}  // namespace

std::vector<fs::path> export_frame(const Landscape& landscape, const fs::path& folder) {
  const fs::path frame_folder = folder / "data" / fmt::format("frame_{:04}", landscape.frame);
  const fs::path volume_folder = folder / "data" / "volumes";
  make_folder(frame_folder);
  make_folder(volume_folder);
  const fs::path blades_folder = folder / "data" / "blades";
  if (!landscape.blade_meshes.empty()) make_folder(blades_folder);
  parallel_for(landscape.blade_meshes.size(),
               [&](std::size_t i) { write_blades(landscape.blade_meshes[i], blades_folder); });
  const ShownInstances<ShownVolume> shown = shown_volumes(landscape);
  const std::vector<VolumeEntry> entries = write_volumes(landscape, shown.all(), volume_folder);
  write_expected_picture(frame_folder / "expected.json", expectation::expected_picture(landscape));
  std::vector<fs::path> files =
      write_frame_data(landscape, frame_folder, entries, shown.picks(), folder / "data");
  files.push_back(frame_folder / "expected.json");
  for (const fs::path& shared : shared_files(landscape, entries, folder / "data"))
    files.push_back(shared);
  return files;
}

}  // namespace wold::blender
