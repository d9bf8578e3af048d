#include "mitsuba/texel_files.h"

#include "core/files.h"
#include "core/vdb_dense.h"
#include "landscape/voxel_albedo.h"
#include "mitsuba/grid_file.h"

namespace wold::mitsuba {
namespace fs = std::filesystem;

std::string texel_name(const landscape::Volume& volume) {
  return volume.vdb.stem().string() + "_" + volume.content;
}

std::vector<fs::path> texel_files(const std::string& name, const fs::path& folder) {
  return {folder / (name + "_extinction.vol"), folder / (name + "_albedo.vol")};
}

void write_texel(const landscape::Volume& volume, const fs::path& folder) {
  const std::vector<fs::path> files = texel_files(texel_name(volume), folder);
  if (fs::exists(files[0]) && fs::exists(files[1])) return;
  const std::vector<float> extinction_per_m =
      read_dense_floats(volume.vdb, "density", glm::ivec3(1), volume.voxels);
  write_file(files[1], grid_bytes(volume.voxels, landscape::voxel_albedo(volume)));
  write_file(files[0], grid_bytes(volume.voxels, extinction_per_m));
}

}  // namespace wold::mitsuba
