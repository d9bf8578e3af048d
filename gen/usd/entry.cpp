#include "usd/entry.h"

#include "usd/export.h"
#include "usd/film_stage.h"

namespace wold::usd {
namespace {

std::vector<std::filesystem::path> export_landscape(const landscape::Landscape& landscape,
                                                    const exporter::FilmSettings& /*film*/,
                                                    const std::filesystem::path& folder) {
  return export_frame(landscape, folder);
}

void export_film(const exporter::FilmSettings& film, const std::filesystem::path& folder) {
  write_film_stage(film.frames, folder);
}

}  // namespace

const exporter::Exporter& entry() {
  static const exporter::Exporter usd = {
      .name = "usd",
      .display_name = "USD",
      .export_frame = export_landscape,
      .export_film = export_film,
      .shared_folders = {"data", "data/volumes", "data/blades", "data/flakes"},
      .needs = {.materials = true},
      // Fitted to what examples/ write: numbers are text.
      .files = {.frame = 1.0e6,
                .frame_ground_sample = 8.5,
                .frame_part = 1650.0,
                .frame_cloud_voxel = 4.0,
                .frame_haze_voxel = 4.0,
                .shared_terrain_sample = 103.0,
                .shared_blade = 1800.0,
                .shared_volume = 20e3,
                .shared_filled_voxel = 8.0}};
  return usd;
}

}  // namespace wold::usd
