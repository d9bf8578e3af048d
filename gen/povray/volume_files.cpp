#include "povray/volume_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>

#include "core/df3.h"
#include "core/files.h"
#include "core/vdb_dense.h"
#include "landscape/emitted_light.h"
#include "povray/text.h"

namespace wold::povray {
namespace fs = std::filesystem;
namespace {

/// Files of numbers NAME<suffix>.df3, and NAME.inc, which says what is in them.
struct GridFiles {
  std::string name;
  std::vector<std::string_view> suffixes;

  fs::path grid(const fs::path& folder, std::string_view suffix) const {
    return folder / fmt::format("{}{}.df3", name, suffix);
  }
  fs::path description(const fs::path& folder) const { return folder / (name + ".inc"); }

  std::vector<fs::path> all(const fs::path& folder) const {
    std::vector<fs::path> files = {description(folder)};
    for (const std::string_view suffix : suffixes) files.push_back(grid(folder, suffix));
    return files;
  }
  /// Second line of the .inc, by which it vouches for the bytes of the df3 files.
  std::string hashes_line(const fs::path& folder) const {
    std::string line = "// files";
    for (const std::string_view suffix : suffixes)
      line += ' ' + content_hash(read_file(grid(folder, suffix)));
    return line + '\n';
  }
  bool are_there(const std::string& first_line, const fs::path& folder) const {
    const auto exists = [](const fs::path& file) { return fs::exists(file); };
    return std::ranges::all_of(all(folder), exists) &&
           read_file(description(folder)).starts_with(first_line + hashes_line(folder));
  }
  /// After the df3 files. An older one stays till then: another process may write the same files,
  /// and a renderer read them, at this moment.
  void describe(const std::string& first_line, std::string_view text,
                const fs::path& folder) const {
    write_file(description(folder), first_line + hashes_line(folder) + include_file(text));
  }
};

GridFiles density_files(const landscape::Volume& volume) { return {density_name(volume), {""}}; }
GridFiles light_files(const landscape::Volume& volume) {
  return {volume.name, {"_l", "_r", "_g", "_b"}};
}
GridFiles files_of(const landscape::CloudBox& cloud) {
  return {cloud.name, {"_d", "_r", "_g", "_b"}};
}

/// First line of an .inc: what its files were made from. The number is that of the layout.
std::string content_line(const GridFiles& files, const landscape::Volume& volume, int bits) {
  return fmt::format("// {}, content {}, {} bit, layout 5\n", files.name, volume.content, bits);
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

std::vector<float> channel_of(std::span<const glm::vec3> grid, int channel) {
  std::vector<float> values;
  values.reserve(grid.size());
  for (const glm::vec3& colour : grid) values.push_back(colour[channel]);
  return values;
}

/// Writes red, green and blue; returns their largest values.
glm::vec3 write_colours(const GridFiles& files, std::span<const glm::vec3> values,
                        glm::ivec3 voxels, int bits, const fs::path& folder) {
  const auto written = [&](std::string_view suffix, int channel) {
    return write_grid(files.grid(folder, suffix), channel_of(values, channel), voxels, bits);
  };
  return {written("_r", 0), written("_g", 1), written("_b", 2)};
}

std::string grid_text(glm::ivec3 voxels, double voxel_m) {
  return fmt::format(
      "#declare Wold_voxels = {};\n"
      "#declare Wold_voxel_m = {};\n",
      vector(voxels), number(voxel_m));
}

std::string extinction_text(float largest) {
  return fmt::format("#declare Wold_extinction_max = {};  // 1/m, of the largest number\n",
                     number(largest));
}

/// A volume's extinction as far up as it matters.
struct Extinction {
  glm::ivec3 voxels;
  std::vector<float> per_m;
};

Extinction read_extinction(const landscape::Volume& volume) {
  Extinction extinction = {volume.voxels,
                           read_dense_floats(volume.vdb, "density", glm::ivec3(1), volume.voxels)};
  extinction.voxels.z = filled_height(extinction.per_m, volume.voxels, fraction_of_tips);
  extinction.per_m.resize(static_cast<std::size_t>(extinction.voxels.x) *
                          static_cast<std::size_t>(extinction.voxels.y) *
                          static_cast<std::size_t>(extinction.voxels.z));
  return extinction;
}

void write_density(const landscape::Volume& volume, const Extinction& extinction, int bits,
                   const fs::path& folder) {
  const GridFiles files = density_files(volume);
  const float largest =
      write_grid(files.grid(folder, ""), extinction.per_m, extinction.voxels, bits);
  files.describe(content_line(files, volume, bits),
                 grid_text(extinction.voxels, volume.voxel_m) + extinction_text(largest), folder);
}

void write_light(const landscape::Volume& volume, const Extinction& extinction, int bits,
                 const fs::path& folder) {
  const glm::ivec3& voxels = extinction.voxels;
  auto radiance = read_dense_vectors(volume.vdb, volume.emission_grid, glm::ivec3(1), voxels);
  const auto [luminance, colours] =
      landscape::emitted_light(extinction.per_m, std::move(radiance), voxels);
  const GridFiles files = light_files(volume);
  const float emission_max = write_grid(files.grid(folder, "_l"), luminance, voxels, bits);
  const glm::vec3 colour_max = write_colours(files, colours.values, colours.voxels, bits, folder);
  files.describe(
      content_line(files, volume, bits),
      grid_text(colours.voxels, 2.0 * volume.voxel_m) +
          fmt::format("#declare Wold_emission_max = {};  // radiance/m, of luminance, in _l\n"
                      "#declare Wold_colour_max = {};  // of luminance 1, in _r, _g, _b\n",
                      number(emission_max), vector(colour_max)),
      folder);
}

bool has_density(const landscape::Volume& volume, int bits, const fs::path& folder) {
  const GridFiles files = density_files(volume);
  return files.are_there(content_line(files, volume, bits), folder);
}

bool has_light(const landscape::Volume& volume, int bits, const fs::path& folder) {
  const GridFiles files = light_files(volume);
  return files.are_there(content_line(files, volume, bits), folder);
}

/// Extinction times radiance.
std::vector<glm::vec3> emission_of(const landscape::CloudBox& cloud) {
  std::vector<glm::vec3> emission(cloud.radiance.size());
  for (std::size_t i = 0; i < emission.size(); ++i)
    emission[i] = cloud.extinction_per_m[i] * cloud.radiance[i];
  return emission;
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

int filled_height(std::span<const float> values, glm::ivec3 voxels, double fraction) {
  const std::size_t slice = static_cast<std::size_t>(voxels.x) * static_cast<std::size_t>(voxels.y);
  std::vector<double> sums(static_cast<std::size_t>(voxels.z), 0.0);
  for (std::size_t z = 0; z < sums.size(); ++z)
    for (const float value : values.subspan(z * slice, slice)) sums[z] += double{value};
  double left = fraction * std::accumulate(sums.begin(), sums.end(), 0.0);
  std::size_t height = sums.size();
  while (height > 1 && sums[height - 1] <= left) left -= sums[--height];
  return static_cast<int>(height);
}

std::string density_name(const landscape::Volume& volume) {
  return volume.vdb.stem().string() + "_d";
}

void write_texel(std::span<const landscape::Volume* const> volumes, int bits,
                 const fs::path& folder) {
  const bool needs_density = !has_density(*volumes.front(), bits, folder);
  std::vector<const landscape::Volume*> unlit;
  for (const landscape::Volume* volume : volumes)
    if (!has_light(*volume, bits, folder)) unlit.push_back(volume);
  if (!needs_density && unlit.empty()) return;
  make_folder(folder);
  const Extinction extinction = read_extinction(*volumes.front());
  if (needs_density) write_density(*volumes.front(), extinction, bits, folder);
  for (const landscape::Volume* volume : unlit) write_light(*volume, extinction, bits, folder);
}

std::vector<fs::path> volume_files(const landscape::Volume& volume, const fs::path& folder) {
  std::vector<fs::path> files = light_files(volume).all(folder);
  for (const fs::path& file : density_files(volume).all(folder)) files.push_back(file);
  return files;
}

void write_cloud(const landscape::CloudBox& cloud, int bits, const fs::path& folder) {
  if (cloud.is_haze) bits = std::max(bits, 16);  // 255 steps to the thickest would be seen
  const GridFiles files = files_of(cloud);
  const float extinction_max =
      write_grid(files.grid(folder, "_d"), cloud.extinction_per_m, cloud.voxels, bits);
  const glm::vec3 emission_max =
      write_colours(files, emission_of(cloud), cloud.voxels, bits, folder);
  files.describe("// A cloud, or snow that blows.\n",
                 grid_text(cloud.voxels, cloud.voxel_m) + extinction_text(extinction_max) +
                     fmt::format("#declare Wold_emission_max = {};  // radiance/m, in _r, _g, _b\n",
                                 vector(emission_max)),
                 folder);
}

std::vector<fs::path> cloud_files(const landscape::CloudBox& cloud, const fs::path& folder) {
  return files_of(cloud).all(folder);
}

}  // namespace wold::povray
