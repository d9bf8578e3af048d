#include "passes/pass.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.h"
#include "passes/cryptomatte.h"

namespace wold::passes {
namespace {

constexpr std::array<PassFacts, 11> table = {{
    {Pass::depth, "depth", "ZA", "m",
     "Z: along the camera's axis (planar) to the ground, or to where grass hides half of what is "
     "behind it, in the middle of the pixel; 1e10 where nothing is. A: fraction of the pixel that "
     "ground and grass cover"},
    {Pass::normal, "normal", "XYZ", "1",
     "unit normal of the ground, with its snow, below what is seen, of blades their own; world "
     "axes: X east, Y north, Z up; 0 where nothing is"},
    {Pass::position, "position", "XYZ", "m",
     "where in the world what has that depth is: X east and Y north from the terrain's "
     "south-western corner, Z up from the scene's zero; 0 where nothing is"},
    {Pass::motion, "motion", "XY", "px/frame",
     "to where the same place is in the next frame's picture: X to the right, Y down; by the "
     "camera, of the sky by its turning, and of grass that waves by its lean"},
    {Pass::species, "species", "", "1",
     "Cryptomatte: what covers the pixel, by name; species that are mingled in one patch count by "
     "the area of their blades in it"},
    {Pass::instance, "instance", "XY", "cell",
     "the cell of grass that is seen, X its column from the west and Y its row from the south, "
     "from 0; -1 where ground or nothing is seen"},
    {Pass::snow, "snow", "V", "m", "depth of the snow that lies at the place that is seen"},
    {Pass::weathering, "weathering", "V", "1",
     "weathering degree of the grass that grows at the place that is seen: 0 fresh, 1 withered"},
    {Pass::wetness, "wetness", "V", "1",
     "how far rain has darkened bare ground at the place that is seen: 0 dry, 1 soaked; 0 under "
     "snow"},
    {Pass::albedo, "albedo", "RGB", "1",
     "fraction of the light that what is seen sends back: the ground's with its snow, or a leaf's "
     "by reflection and transmission; linear sRGB; 0 where nothing is"},
    {Pass::light, "light", "RGB", "1",
     "light on the ground, with its snow, at the place that is seen, before grass shades it: "
     "irradiance by sun, sky and clouds in units of level, open ground's on a clear day; linear "
     "sRGB; 0 where nothing is"},
}};

std::vector<std::string_view> names() {
  std::vector<std::string_view> names;
  for (const PassFacts& facts : table) names.push_back(facts.name);
  return names;
}

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace

std::span<const PassFacts> all_passes() { return table; }

const PassFacts& facts_of(Pass pass) { return table[static_cast<std::size_t>(pass)]; }

double bytes_per_pixel(Pass pass, std::size_t names) {
  constexpr double half = 2.0, whole = 4.0;
  switch (pass) {
    case Pass::depth:
      return whole + half;
    case Pass::position:
      return 3.0 * whole;
    case Pass::motion:
    case Pass::instance:
      return 2.0 * whole;
    case Pass::species:
      return whole * static_cast<double>(Cryptomatte::channels_of(names));
    case Pass::snow:
    case Pass::weathering:
    case Pass::wetness:
      return half;
    case Pass::normal:
    case Pass::albedo:
    case Pass::light:
      return 3.0 * half;
  }
  return 0.0;
}

std::string names_of_all() { return fmt::format("{}", fmt::join(names(), ", ")); }

std::vector<Pass> passes_of(std::string_view text) {
  const std::vector<std::string_view> parts = parts_of(text);
  for (const std::string_view part : parts)
    if (part != "all" && std::ranges::count(table, part, &PassFacts::name) == 0)
      throw InputError(
          fmt::format("--passes: found \"{}\", expected some of {}, or all", part, names_of_all()));
  std::vector<Pass> passes;
  for (const PassFacts& facts : table)
    if (std::ranges::count(parts, facts.name) > 0 || std::ranges::count(parts, "all") > 0)
      passes.push_back(facts.pass);
  return passes;
}

std::string text_of(std::span<const Pass> passes) {
  if (passes.size() == table.size()) return "all";
  std::vector<std::string_view> words;
  for (const Pass pass : passes) words.push_back(facts_of(pass).name);
  return fmt::format("{}", fmt::join(words, ","));
}

}  // namespace wold::passes
