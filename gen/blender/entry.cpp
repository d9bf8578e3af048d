#include "blender/entry.h"

#include <fmt/format.h>

#include "blender/export.h"
#include "blender/renderer.h"
#include "blender/volume_stack.h"
#include "core/error.h"

namespace wold::blender {
namespace {

std::vector<std::filesystem::path> export_landscape(const landscape::Landscape& landscape,
                                                    const exporter::FilmSettings&,
                                                    const std::filesystem::path& folder) {
  return export_frame(landscape, folder);
}

/// Blender leaves volumes out where too many lie over each other, without a word: on sharply bent
/// ground, where a patch is laid in many parts, or behind many clouds.
std::string warning_of(const landscape::Landscape& landscape) {
  const int deepest = deepest_volume_stack(landscape);
  if (deepest < many_volumes) return {};
  const std::string found = fmt::format(
      "frame {}: {} volumes lie over one place before the camera, and Blender leaves out what is "
      "beyond {}; set grass.patch to less, render.grass = \"blades\" or render.renderer = "
      "\"povray\"",
      landscape.frame, deepest, volumes_on_a_stack - 1);
  if (deepest >= volumes_on_a_stack) throw InputError(found);
  return found;
}

/// From runs of examples/ on 2 processors: right within a factor of two for scenes like those.
double seconds_per_megapixel(int samples) { return 20.0 * samples; }

}  // namespace

const exporter::Exporter& entry() {
  static const exporter::Exporter blender = {
      .name = "blender",
      .display_name = render::display_name(renderer()),
      .export_frame = export_landscape,
      .shared_folders = {"data", "data/volumes", "data/blades", "data/flakes"},
      .warning_of = warning_of,
      // Fitted to what examples/ write.
      .files = {.frame = 0.9e6,
                .frame_terrain_sample = 4.0,
                .frame_ground_sample = 2.7,
                .frame_light_sample = 4.2,
                .frame_part = 100.0,
                .frame_cloud_voxel = 1.1,
                .frame_haze_voxel = 3.5,
                .shared_blade = 1000.0,
                .shared_volume = 20e3,  // names, tree and what else does not grow with its voxels
                .shared_filled_voxel = 5.0},
      .renderer = &renderer(),
      // Blender 3.4 keeps the whole box of a volume, two numbers a voxel and a pixel for eight, and
      // OpenVDB's trees beside it; newer ones take less.
      .memory = {.start = 660e6,
                 .ground_sample = 30.0,
                 .cloud_voxel = 22.0,
                 .haze_voxel = 22.0,
                 .terrain_sample = 600.0,
                 .part = 9000.0,
                 .blade = 5000.0,
                 .voxel = 8.5,
                 .filled_voxel = 60.0},
      .seconds_per_megapixel = seconds_per_megapixel};
  return blender;
}

}  // namespace wold::blender
