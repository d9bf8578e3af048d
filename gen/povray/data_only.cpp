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
constexpr std::array<std::string_view, 61> words = {
    "Wold_backdrop_corner_m",
    "Wold_backdrop_right_m",
    "Wold_backdrop_up_m",
    "Wold_blade_light_corner_m",
    "Wold_blade_light_max",
    "Wold_blade_light_samples",
    "Wold_blade_light_step_m",
    "Wold_blades",
    "Wold_boulders_file",
    "Wold_boulders_mesh",
    "Wold_boulders_origin_m",
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
    "Wold_light_detail",
    "Wold_light_max",
    "Wold_light_samples",
    "Wold_light_step_m",
    "Wold_mesh",
    "Wold_meshes",
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
    constexpr auto is_of_name = [](char c) { return is_of_word(c) || c == '-'; };
    const std::string_view name = rest_.substr(1);
    std::size_t end =
        1 + static_cast<std::size_t>(std::ranges::find_if_not(name, is_of_name) - name.begin());
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

void require_folder(const fs::path& folder) {
  if (fs::is_symlink(folder) && fs::is_directory(folder))
    throw FileError(
        fmt::format("{}: found a link to a folder, expected a folder", folder.string()));
}

/// Adds the include files below a folder, which may be missing, and cells.txt.
void add_include_files(const fs::path& folder, std::vector<fs::path>& files) {
  require_folder(folder);
  if (!fs::exists(folder)) return;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    require_folder(entry.path());
    if (entry.path().extension() == ".inc" || entry.path().filename() == "cells.txt")
      files.push_back(entry.path());
  }
}

/// The files of data/ that a text has the scene program include by a name of its own. They end as
/// all do, or POV-Ray might find one with another ending.
std::vector<std::string> named_files_in(std::string_view text, std::string_view word,
                                        const fs::path& file) {
  constexpr std::string_view sign = " = \"", ending = ".inc\"";
  std::vector<std::string> names;
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word)) {
    text.remove_prefix(at + word.size());
    const std::size_t end = text.find('"', sign.size());
    const bool is_name = text.starts_with(sign) && end != std::string_view::npos &&
                         text.substr(0, end + 1).ends_with(ending);
    if (!is_name)
      throw FileError(fmt::format("{}: found {}{}, expected the name of a file that ends in .inc",
                                  file.string(), word,
                                  text.substr(0, std::min(max_shown, text.find('\n')))));
    names.emplace_back(text.substr(sign.size(), end - sign.size()));
  }
  return names;
}

/// What the scene program includes of a frame, but for what the files themselves name. data/ is not
/// looked through: it has a folder of every frame.
std::vector<fs::path> include_files(const fs::path& data, const std::string& own) {
  std::vector<fs::path> files;
  require_folder(data);
  for (const fs::path& folder : {data / own, data / "volumes", data / "blades"})
    add_include_files(folder, files);
  if (const fs::path all = data / "frames.inc"; fs::exists(all)) files.push_back(all);
  return files;
}

/// Adds those that a text names and that are not there yet.
void add_named_files(std::string_view text, const fs::path& file, const fs::path& data,
                     std::vector<fs::path>& files) {
  for (const char* word : {"Wold_terrain_file", "Wold_boulders_file"})
    for (const std::string& name : named_files_in(text, word, file))
      if (fs::exists(data / name) && std::ranges::find(files, data / name) == files.end())
        files.push_back(data / name);
}

void require_data_only_in(const std::string& text, const fs::path& file) {
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
  const fs::path data = folder / "data";
  try {
    std::vector<fs::path> files = include_files(data, fmt::format("frame_{:04}", frame));
    for (std::size_t i = 0; i < files.size(); ++i) {  // what is named may name others
      const fs::path file = files[i];
      const std::string text = read_file(file);
      add_named_files(text, file, data, files);
      require_data_only_in(text, file);
    }
  } catch (const fs::filesystem_error& error) {
    throw FileError(
        fmt::format("cannot read {}: {}", error.path1().string(), error.code().message()));
  }
}

}  // namespace wold::povray
