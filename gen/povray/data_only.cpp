#include "povray/data_only.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/files.h"
#include "core/number_text.h"

namespace wold::povray {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t max_shown = 40;

constexpr std::array<std::string_view, 3> directives = {"declare", "local", "version"};

/// What stands in files of data: nothing that reads, writes, includes or makes a string, and none
/// of the scene program's own names of files and folders.
constexpr std::array<std::string_view, 60> words = {
    "Wold_backdrop_corner_m",
    "Wold_backdrop_right_m",
    "Wold_backdrop_up_m",
    "Wold_blade_cell",
    "Wold_blade_light_corner_m",
    "Wold_blade_light_max",
    "Wold_blade_light_samples",
    "Wold_blade_light_step_m",
    "Wold_blades",
    "Wold_cell",
    "Wold_cloud",
    "Wold_colour_max",
    "Wold_emission_max",
    "Wold_exposure_gain",
    "Wold_extinction_max",
    "Wold_eye_m",
    "Wold_field_of_view_deg",
    "Wold_flake_picture",
    "Wold_flake_pictures",
    "Wold_flake_radiance",
    "Wold_flake_texture",
    "Wold_flakes",
    "Wold_fog_extinction_per_m",
    "Wold_fog_radiance",
    "Wold_frames",
    "Wold_grass_density",
    "Wold_ground_detail",
    "Wold_ground_samples",
    "Wold_ground_step_m",
    "Wold_light_corner_m",
    "Wold_light_max",
    "Wold_light_samples",
    "Wold_light_step_m",
    "Wold_mesh",
    "Wold_meshes",
    "Wold_part",
    "Wold_patch_m",
    "Wold_sky_irradiance",
    "Wold_standing_corner_m",
    "Wold_standing_max",
    "Wold_standing_samples",
    "Wold_standing_step_m",
    "Wold_sun_irradiance",
    "Wold_target_m",
    "Wold_terrain_file",
    "Wold_terrain_mesh",
    "Wold_to_sun",
    "Wold_volume",
    "Wold_volumes",
    "Wold_voxel_m",
    "Wold_voxels",
    "_version",
    "array",
    "face_indices",
    "mesh2",
    "texture_list",
    "uv_indices",
    "uv_vectors",
    "version",
    "vertex_vectors",
};

bool is_in(const auto& list, std::string_view word) {
  return std::ranges::find(list, word) != std::ranges::end(list);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
}

/// Reads a file's text from its beginning, as far as it is data.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  /// Whether all of it is data; if not, rest() is what is none.
  bool is_data() {
    while (!rest_.empty())
      if (!skip_token()) return false;
    return true;
  }
  std::string_view rest() const { return rest_; }

 private:
  bool skip_token() {
    const char c = rest_.front();
    if (rest_.starts_with("//")) return skip_comment();
    if (c == '#') return skip_word(directives, 1);
    if (c == '"') return skip_string();
    if (is_digit(c)) return skip_number();
    if (is_of_word(c)) return skip_word(words, 0);
    constexpr std::string_view others = " \n{}<>(),;=.-[]";
    return others.find(c) != std::string_view::npos && skip(1);
  }
  bool skip(std::size_t bytes) {
    rest_.remove_prefix(bytes);
    return true;
  }
  /// Printable, since POV-Ray might take another control character for the end of the line.
  bool skip_comment() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    return std::ranges::all_of(rest_.substr(0, end), [](char c) { return c >= ' ' && c <= '~'; }) &&
           skip(end);
  }
  bool skip_word(const auto& known, std::size_t mark) {
    const std::size_t length = length_of_word(mark);
    return is_in(known, rest_.substr(mark, length)) && skip(mark + length);
  }
  /// The name of a file beside this one, without any dot but that of its extension.
  bool skip_string() {
    std::size_t end = 1 + length_of_word(1);
    if (rest_.substr(end).starts_with(".inc")) end += 4;
    return rest_.substr(end).starts_with('"') && skip(end + 1);
  }
  bool skip_number() {
    const auto number = leading_number<double>(rest_);
    return number && length_of_word(number->length) == 0 && skip(number->length);
  }
  std::size_t length_of_word(std::size_t begin) const {
    const std::string_view text = rest_.substr(begin);
    return static_cast<std::size_t>(std::ranges::find_if_not(text, is_of_word) - text.begin());
  }

  std::string_view rest_;
};

/// Those below `data`, but for the folders of frames with other names than `own`.
std::vector<fs::path> include_files(const fs::path& data, const std::string& own) {
  std::vector<fs::path> files;
  for (auto entry = fs::recursive_directory_iterator(data); entry != end(entry); ++entry) {
    const fs::path& path = entry->path();
    const std::string name = path.filename().string();
    if (entry->is_symlink() && entry->is_directory())
      throw FileError(
          fmt::format("{}: found a link to a folder, expected a folder", path.string()));
    if (entry->is_directory() && name.starts_with("frame_") && name != own)
      entry.disable_recursion_pending();
    if (path.extension() == ".inc") files.push_back(path);
  }
  return files;
}

void require_data_only_in(const fs::path& file) {
  const std::string text = read_file(file);
  Reader reader(text);
  if (reader.is_data()) return;
  const auto at = static_cast<std::ptrdiff_t>(text.size() - reader.rest().size());
  throw FileError(fmt::format(
      "{}:{}: found \"{}\", expected numbers and names as wold writes them: the file was changed "
      "and is not given to POV-Ray. Remove it, and the same command makes it anew",
      file.string(), 1 + std::count(text.begin(), text.begin() + at, '\n'),
      reader.rest().substr(0, std::min(max_shown, reader.rest().find('\n')))));
}

}  // namespace

void require_data_only(const fs::path& folder, int frame) {
  try {
    for (const fs::path& file : include_files(folder / "data", fmt::format("frame_{:04}", frame)))
      require_data_only_in(file);
  } catch (const fs::filesystem_error& error) {
    throw FileError(
        fmt::format("cannot read {}: {}", error.path1().string(), error.code().message()));
  }
}

}  // namespace wold::povray
