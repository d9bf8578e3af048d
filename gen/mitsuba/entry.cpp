#include "mitsuba/entry.h"

#include "mitsuba/export.h"

namespace wold::mitsuba {
namespace {

std::vector<std::filesystem::path> export_landscape(const landscape::Landscape& landscape,
                                                    const exporter::FilmSettings& /*film*/,
                                                    const std::filesystem::path& folder) {
  return export_frame(landscape, folder);
}

}  // namespace

const exporter::Exporter& entry() {
  static const exporter::Exporter mitsuba = {
      .name = "mitsuba",
      .display_name = "Mitsuba",
      .export_frame = export_landscape,
      .shared_folders = {"data", "data/texels", "data/leaves"},
      .needs = {.materials = true},
      // By what the files hold: ground and sky as floats, a PLY terrain of 46 bytes a height; four
      // floats a voxel of a texel, of which the file has all.
      .files = {.frame = 4.0e6,
                .frame_ground_sample = 6.1,
                .frame_part = 500.0,
                .frame_cloud_voxel = 4.0,
                .shared_terrain_sample = 46.0,
                .shared_blade = 3000.0}};
  return mitsuba;
}

}  // namespace wold::mitsuba
