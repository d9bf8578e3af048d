#include "povray/volume_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "core/df3.h"
#include "core/files.h"
#include "core/vdb_dense.h"
#include "povray/text.h"

namespace wold::povray {
namespace fs = std::filesystem;
namespace {

constexpr std::array<const char*, 4> suffixes = {"d", "r", "g", "b"};

fs::path grid_file(const fs::path& folder, const std::string& name, int grid) {
  return folder / fmt::format("{}_{}.df3", name, suffixes[static_cast<std::size_t>(grid)]);
}

/// First line of the .inc: what these files were made from. The number is that of the layout.
std::string content_line(const landscape::Volume& volume, int bits) {
  return fmt::format("// {}, content {}, {} bit, layout 3\n", volume.name, volume.content, bits);
}

/// Second line of the .inc, by which it vouches for the bytes of the four df3 files.
std::string files_line(const std::string& name, const fs::path& folder) {
  std::string line = "// files";
  for (int grid = 0; grid < 4; ++grid)
    line += ' ' + content_hash(read_file(grid_file(folder, name, grid)));
  return line + '\n';
}

bool is_there(const landscape::Volume& volume, int bits, const fs::path& folder) {
  const fs::path description = folder / (volume.name + ".inc");
  if (!fs::exists(description)) return false;
  for (int grid = 0; grid < 4; ++grid)
    if (!fs::exists(grid_file(folder, volume.name, grid))) return false;
  return read_file(description)
      .starts_with(content_line(volume, bits) + files_line(volume.name, folder));
}

/// Writes one df3 file scaled by its largest value, which is returned.
float write_grid(const fs::path& path, std::span<const float> values, glm::ivec3 voxels, int bits) {
  const float largest =
      std::max(*std::max_element(values.begin(), values.end()), std::numeric_limits<float>::min());
  const std::vector<float> samples = padded(values, voxels);
  write_file(path, [&](std::ostream& out) {
    write_df3(out, padded_size(voxels), samples, largest, bits);
  });
  return largest;
}

std::vector<float> weighted_channel(std::span<const float> extinction,
                                    std::span<const glm::vec3> radiance, int channel) {
  std::vector<float> product(extinction.size());
  for (std::size_t i = 0; i < product.size(); ++i)
    product[i] = extinction[i] * radiance[i][channel];
  return product;
}

/// A volume's numbers and what is said about them.
struct Grids {
  std::string name;
  std::string first_line;  ///< of the .inc
  glm::ivec3 voxels;
  double voxel_m;
  std::span<const float> extinction;
  std::span<const glm::vec3> radiance;
};

std::string description(const Grids& grids, float extinction_max, glm::vec3 emission_max) {
  return fmt::format(
      "#declare Wold_voxels = {};\n"
      "#declare Wold_voxel_m = {};\n"
      "#declare Wold_extinction_max = {};  // 1/m, of the largest number in _d\n"
      "#declare Wold_emission_max = {};  // radiance/m, in _r, _g, _b\n",
      vector(grids.voxels), number(grids.voxel_m), number(extinction_max), vector(emission_max));
}

/// Four df3 files and, last, the .inc that vouches for them. An older one stays till then: another
/// process may write the same files, and a renderer read them, at this moment.
void write_grids(const Grids& grids, int bits, const fs::path& folder) {
  const float extinction_max =
      write_grid(grid_file(folder, grids.name, 0), grids.extinction, grids.voxels, bits);
  glm::vec3 emission_max(0.0F);
  for (int channel = 0; channel < 3; ++channel)
    emission_max[channel] =
        write_grid(grid_file(folder, grids.name, channel + 1),
                   weighted_channel(grids.extinction, grids.radiance, channel), grids.voxels, bits);
  write_file(folder / (grids.name + ".inc"),
             grids.first_line + files_line(grids.name, folder) +
                 include_file(description(grids, extinction_max, emission_max)));
}

}  // namespace

glm::ivec3 padded_size(glm::ivec3 voxels) { return voxels + 2; }

std::vector<float> padded(std::span<const float> values, glm::ivec3 voxels) {
  const glm::ivec3 size = padded_size(voxels);
  std::vector<float> samples;
  samples.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                  static_cast<std::size_t>(size.z));
  const auto row_at = [&](int y, int z) {
    return values.data() + (static_cast<std::size_t>(z) * static_cast<std::size_t>(voxels.y) +
                            static_cast<std::size_t>(y)) *
                               static_cast<std::size_t>(voxels.x);
  };
  for (int z = -1; z < voxels.z; ++z)
    for (int y = -1; y <= voxels.y; ++y) {
      const float* row = row_at((y + voxels.y) % voxels.y, std::max(z, 0));
      samples.push_back(row[voxels.x - 1]);
      samples.insert(samples.end(), row, row + voxels.x);
      samples.push_back(row[0]);
    }
  samples.resize(samples.capacity(), 0.0F);
  return samples;
}

int filled_height(std::span<const float> values, glm::ivec3 voxels) {
  const auto last = std::find_if(values.rbegin(), values.rend(), [](float v) { return v > 0.0F; });
  const auto filled = static_cast<std::size_t>(values.rend() - last);
  const std::size_t slice = static_cast<std::size_t>(voxels.x) * static_cast<std::size_t>(voxels.y);
  return std::max(1, static_cast<int>((filled + slice - 1) / slice));
}

void write_volume(const landscape::Volume& volume, int bits, const fs::path& folder) {
  if (is_there(volume, bits, folder)) return;
  make_folder(folder);
  const glm::ivec3 first(1);
  std::vector<float> extinction = read_dense_floats(volume.vdb, "density", first, volume.voxels);
  glm::ivec3 voxels = volume.voxels;
  voxels.z = filled_height(extinction, voxels);
  extinction.resize(static_cast<std::size_t>(voxels.x) * static_cast<std::size_t>(voxels.y) *
                    static_cast<std::size_t>(voxels.z));
  const auto radiance = read_dense_vectors(volume.vdb, volume.emission_grid, first, voxels);
  write_grids(
      {volume.name, content_line(volume, bits), voxels, volume.voxel_m, extinction, radiance}, bits,
      folder);
}

std::vector<fs::path> volume_files(const std::string& name, const fs::path& folder) {
  std::vector<fs::path> files = {folder / (name + ".inc")};
  for (int grid = 0; grid < 4; ++grid) files.push_back(grid_file(folder, name, grid));
  return files;
}

void write_cloud(const landscape::CloudBox& cloud, int bits, const fs::path& folder) {
  write_grids({cloud.name, "// A cloud.\n", cloud.voxels, cloud.voxel_m, cloud.extinction_per_m,
               cloud.radiance},
              bits, folder);
}

}  // namespace wold::povray
