#include "povray/entry.h"

#include <cmath>

#include "povray/export.h"
#include "povray/renderer.h"

namespace wold::povray {
namespace {

namespace fs = std::filesystem;

/// Of the box of voxels that a patch's height asks for, without the tips of its blades: extinction,
/// and for each quarter-turn luminance, and red, green and blue at half the resolution.
constexpr double below_tips = 0.86;
constexpr double grids_of_a_texel = below_tips;
constexpr double grids_of_a_volume = below_tips * (1.0 + 3.0 / 8.0);

std::vector<fs::path> export_landscape(const landscape::Landscape& landscape,
                                       const exporter::FilmSettings& film, const fs::path& folder) {
  return export_frame(landscape, folder, film.density_bits);
}

void export_film(const exporter::FilmSettings& film, const fs::path& folder) {
  export_scene(film.frames, folder);
  export_settings(film.size_px, film.samples, folder);
}

/// From runs of examples/ on 2 processors: right within a factor of two for scenes like those.
/// Samples adapt to what is seen.
double seconds_per_megapixel(int samples) { return 70.0 * std::sqrt(samples); }

}  // namespace

const exporter::Exporter& entry() {
  static const exporter::Exporter povray = {
      .name = "povray",
      .display_name = render::display_name(renderer()),
      .export_frame = export_landscape,
      .export_film = export_film,
      .shared_folders = {"data", "data/volumes", "data/blades", "data/flakes"},
      // POV-Ray takes its settings from where it is started: `povray povray/scene.pov` from the
      // output folder, too.
      .files_for_output_folder = {"povray.ini"},
      // POV-Ray ends abruptly when a ray has passed some 240 surfaces and still sees more than
      // 1/255 of what is behind; where the average is less than half of them, no ray comes near
      // that.
      .needs = {.max_flakes_on_a_ray = 110.0},
      // Fitted to what examples/ write.
      .files = {.frame = 0.3e6,
                .frame_ground_sample = 2.7,
                .frame_light_sample = 8.0,
                .frame_part = 200.0,
                .frame_cloud_voxel = 4.3,
                .frame_haze_voxel = 8.4,
                .shared_terrain_sample = 65.0,  // the shape of the ground
                .shared_blade = 2500.0,
                .shared_density_grids = grids_of_a_volume,
                .shared_texel_grids = grids_of_a_texel},
      .renderer = &renderer(),
      // POV-Ray keeps df3 files as they are.
      .memory = {.start = 115e6,
                 .ground_sample = 10.0,
                 .cloud_voxel = 4.3,
                 .haze_voxel = 8.4,
                 .terrain_sample = 480.0,
                 .part = 8900.0,
                 .blade = 5000.0,
                 .density_grids = grids_of_a_volume,
                 .texel_grids = grids_of_a_texel},
      .seconds_per_megapixel = seconds_per_megapixel};
  return povray;
}

}  // namespace wold::povray
