#include "compare/inspect.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "compare/file_kind.h"
#include "compare/inspect_layers.h"
#include "compare/vdb.h"
#include "core/df3.h"
#include "core/error.h"
#include "core/image.h"
#include "core/layered_image.h"
#include "core/printable.h"

namespace wold::compare {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;
using Problems = std::vector<std::string>;

void describe_df3(const fs::path& path, Json& facts, Problems& problems) {
  const Df3 grid = read_df3(path);
  const auto [min, largest] = std::ranges::minmax(grid.values);
  facts["size"] = {grid.size.x, grid.size.y, grid.size.z};
  facts["bits"] = grid.bits;
  facts["range"] = {min, largest};
  facts["memory_bytes"] = grid.values.size() * static_cast<std::size_t>(grid.bits / 8);
  if (largest <= 0.0F) problems.emplace_back("every value is 0");
}

Json metadata_json(const std::vector<std::pair<std::string, std::string>>& metadata) {
  Json json = Json::object();
  for (const auto& [name, value] : metadata) json[name] = value;
  return json;
}

Json grid_json(const GridFacts& grid) {
  Json json = {{"name", grid.name}, {"type", grid.type}, {"stored_as_half", grid.stored_as_half}};
  json["box_min"] = {grid.box_min.x, grid.box_min.y, grid.box_min.z};
  json["box_max"] = {grid.box_max.x, grid.box_max.y, grid.box_max.z};
  json["voxel_m"] = {grid.voxel_m.x, grid.voxel_m.y, grid.voxel_m.z};
  json["active_voxels"] = grid.active_voxels;
  if (grid.has_range) json["range"] = {grid.min, grid.largest};
  json["memory_bytes"] = grid.memory_bytes;
  json["metadata"] = metadata_json(grid.metadata);
  return json;
}

void describe_vdb(const fs::path& path, Json& facts, Problems& problems) {
  const VdbFacts file = vdb_facts(path);
  facts["metadata"] = metadata_json(file.metadata);
  facts["grids"] = Json::array();
  if (file.grids.empty()) problems.emplace_back("the file has no grids");
  for (const GridFacts& grid : file.grids) {
    facts["grids"].push_back(grid_json(grid));
    if (grid.active_voxels == 0)
      problems.push_back(fmt::format("grid {} has no active voxels", grid.name));
    if (grid.non_finite > 0)
      problems.push_back(
          fmt::format("grid {}: {} values are no finite numbers", grid.name, grid.non_finite));
  }
}

template <class Counts>
std::uint64_t total(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

/// Of a picture that is made of layers.
void describe_layers(const LayeredImage& image, Json& facts, Problems& problems) {
  facts["width"] = image.width;
  facts["height"] = image.height;
  facts["channels"] = image.channels.size();
  facts.update(header_json(image));
  facts["layers"] = layers_json(image);
  facts["memory_bytes"] = image.pixels() * image.channels.size() * sizeof(float);
  for (const ImageChannel& channel : image.channels)
    if (const auto bad = std::ranges::count_if(channel.values,
                                               [](float value) { return !std::isfinite(value); });
        bad > 0)
      problems.push_back(fmt::format("{}: {} values are no finite numbers", channel.name, bad));
}

/// Whether all pixels have one colour, if need be dithered to steps of 8 bits.
bool is_blank(const OIIO::ImageBufAlgo::PixelStats& statistics, const std::string& stored_as) {
  const float spread = stored_as == "uint8" ? 1.001F / 255.0F : 0.0F;
  for (std::size_t channel = 0; channel < statistics.min.size(); ++channel)
    if (statistics.max[channel] - statistics.min[channel] > spread) return false;
  return true;
}

void describe_picture(const fs::path& path, Json& facts, Problems& problems) {
  if (const LayeredImage layered = read_layered_image(path); has_layers(layered))
    return describe_layers(layered, facts, problems);
  Image image = read_image(path);
  const OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT);
  const OIIO::ImageBuf pixels(spec, image.values.data());
  const auto statistics = OIIO::ImageBufAlgo::computePixelStats(pixels);
  facts["width"] = image.width;
  facts["height"] = image.height;
  facts["channels"] = image.channels;
  const std::string stored_as = read_image_header(path).stored_as;
  facts["stored_as"] = stored_as;
  facts["least"] = statistics.min;
  facts["largest"] = statistics.max;
  facts["mean"] = statistics.avg;
  facts["nan_count"] = total(statistics.nancount);
  facts["infinite_count"] = total(statistics.infcount);
  const bool blank = is_blank(statistics, stored_as);
  facts["blank"] = blank;
  facts["memory_bytes"] = image.values.size() * sizeof(float);
  if (const auto bad = total(statistics.nancount) + total(statistics.infcount); bad > 0)
    problems.push_back(fmt::format("{} values are no finite numbers", bad));
  if (blank) problems.emplace_back("the picture is blank: every pixel has the same colour");
}

void describe(FileKind kind, const fs::path& path, Json& facts, Problems& problems) {
  switch (kind) {
    case FileKind::df3:
      return describe_df3(path, facts, problems);
    case FileKind::vdb:
      return describe_vdb(path, facts, problems);
    case FileKind::picture:
      return describe_picture(path, facts, problems);
  }
}

/// One line per value, lists in one line, what belongs to something indented below it.
std::string as_lines(const Json& json, std::string_view indent) {
  std::string text;
  for (const auto& [key, value] : json.items()) {
    const bool nests =
        value.is_object() || (value.is_array() && !value.empty() && !value.front().is_number());
    const std::string plain = value.is_string() ? value.get<std::string>() : value.dump();
    if (nests && !value.empty())
      text += fmt::format("{}{}:\n{}", indent, key, as_lines(value, std::string(indent) + "  "));
    else
      text += fmt::format("{}{}: {}\n", indent, key, plain);
  }
  return text;
}

}  // namespace

Inspection inspect(const fs::path& path) {
  const FileKind kind = file_kind(path);
  Json facts = {{"version", 1},
                {"file", path.string()},
                {"kind", to_string(kind)},
                {"bytes", fs::file_size(path)}};
  Inspection result;
  try {
    describe(kind, path, facts, result.problems);
  } catch (const FileError& error) {
    result.problems.emplace_back(error.what());
  }
  facts["problems"] = result.problems;
  result.json = facts.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  facts.erase("version");
  result.text = printable(as_lines(facts, ""));
  return result;
}

}  // namespace wold::compare
