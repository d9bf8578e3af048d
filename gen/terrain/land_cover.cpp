#include "terrain/land_cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/quiet_gdal.h"
#include "core/random.h"
#include "terrain/river_levels.h"
#include "terrain/scene_place.h"
#include "terrain/thinned_cells.h"

namespace wold::terrain {
namespace {

constexpr int most_cells = 2048;  // along a side

/// Its system is the scene's where it does not say its own.
Raster cover_raster(const scene::Terrain& terrain) {
  constexpr const char* key = "terrain.cover";
  Raster raster(terrain.cover, "", key);
  return raster.system() != nullptr || terrain.system.empty()
             ? std::move(raster)
             : Raster(terrain.cover, terrain.system, key);
}

/// By the number that stands for it.
std::map<int, int> indices_of(const std::vector<scene::CoverClass>& classes) {
  std::map<int, int> indices;
  for (std::size_t k = 0; k < classes.size(); ++k)
    indices.emplace(classes[k].number, static_cast<int>(k));
  return indices;
}

void require_classes(const Raster& raster, const ThinnedCells& cells) {
  for (const double value : cells.block.values)
    if (!std::isnan(value) && (value != std::rint(value) || std::abs(value) > 1e9))
      raster.fail(fmt::format("found {}, expected the numbers of classes, which are whole", value));
}

/// Places of one lake or river of the cover's.
using Places = std::vector<glm::ivec2>;

/// The places beside one, by sides and corners, on the map.
template <class Visit>
void each_neighbour(const glm::ivec2& at, const GroundMap<int>& map, const Visit& visit) {
  const int last = map.samples() - 1;
  for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, last); ++y)
    for (int x = std::max(at.x - 1, 0); x <= std::min(at.x + 1, last); ++x)
      if (glm::ivec2(x, y) != at) visit(glm::ivec2(x, y));
}

/// The water that hangs together with a place, which is marked as seen.
Places water_about(const LandCover& cover, const glm::ivec2& first, GroundMap<int>& seen) {
  Places places = {first};
  seen.at(first.x, first.y) = 1;
  for (std::size_t next = 0; next < places.size(); ++next) {
    const glm::ivec2 place = places[next];
    each_neighbour(place, seen, [&](const glm::ivec2& at) {
      if (seen.at(at.x, at.y) != 0 || !cover.is_water(at.x, at.y)) return;
      seen.at(at.x, at.y) = 1;
      places.push_back(at);
    });
  }
  return places;
}

std::vector<double> heights_of(const Places& places, const LandCover& cover,
                               const Heightfield& heights_m) {
  std::vector<double> heights;
  for (const glm::ivec2& at : places) {
    const glm::dvec2 at_m = cover.number().place_m(at.x, at.y);
    heights.push_back(double{heights_m.sample(at_m.x, at_m.y)});
  }
  return heights;
}

/// The level of water as level as a lake: what is measured on water is uneven by some metres, and a
/// river falls. None where it is a river.
std::optional<double> level_of_lake(std::vector<double> heights_m) {
  constexpr double most_uneven_m = 6.0;
  std::ranges::sort(heights_m);
  const std::size_t tenth = heights_m.size() / 10;
  if (heights_m[heights_m.size() - 1 - tenth] - heights_m[tenth] > most_uneven_m)
    return std::nullopt;
  return heights_m[heights_m.size() / 2];
}

/// A river, and how high it stands in each place.
struct River {
  Places places;
  std::vector<double> levels_m;
};

/// The map of lakes with twice as many steps to a cell, in which rivers stand: each place is a lake
/// of its own, as its neighbours stand about as high. A place is three steps wide: Water shows
/// hardly anything narrower.
Lakes with_rivers(const Lakes& lakes, const std::vector<River>& rivers) {
  const GroundMap<int>& coarse = lakes.number;
  const int last = 2 * (coarse.samples() - 1);
  Lakes all{GroundMap<int>(last + 1, coarse.square(), -1), lakes.levels_m};
  for (int j = 0; j <= last; ++j)
    for (int i = 0; i <= last; ++i) all.number.at(i, j) = coarse.at((i + 1) / 2, (j + 1) / 2);
  const auto paint = [&](const glm::ivec2& middle, int number) {
    for (int y = std::max(middle.y - 1, 0); y <= std::min(middle.y + 1, last); ++y)
      for (int x = std::max(middle.x - 1, 0); x <= std::min(middle.x + 1, last); ++x)
        all.number.at(x, y) = number;
  };
  for (const River& river : rivers) {
    const int first = static_cast<int>(all.levels_m.size());
    for (std::size_t k = 0; k < river.places.size(); ++k)
      paint(2 * river.places[k], first + static_cast<int>(k));
    all.levels_m.insert(all.levels_m.end(), river.levels_m.begin(), river.levels_m.end());
  }
  return all;
}

/// The cover's water: all that hangs together, place by place.
std::vector<Places> waters_of(const LandCover& cover) {
  const GroundMap<int>& number = cover.number();
  GroundMap<int> seen(number.samples(), number.square(), 0);
  std::vector<Places> waters;
  for (int j = 0; j < number.samples(); ++j)
    for (int i = 0; i < number.samples(); ++i)
      if (seen.at(i, j) == 0 && cover.is_water(i, j))
        waters.push_back(water_about(cover, {i, j}, seen));
  return waters;
}

}  // namespace

LandCover::LandCover(GroundMap<int> number, std::vector<scene::CoverClass> kinds,
                     std::uint64_t seed)
    : number_(std::move(number)),
      kinds_(std::move(kinds)),
      bays_{random_bits({seed, key_of("cover"), 0, key_of("bays")}), /*octaves=*/7, /*hurst=*/0.8} {
}

bool LandCover::is_water(int i, int j) const {
  const int kind = number_.at(i, j);
  return kind >= 0 && kinds_[static_cast<std::size_t>(kind)].water >= 0.5;
}

LandCover::Shares LandCover::at(const glm::dvec2& at_m) const {
  constexpr double bays = 0.35, feature_steps = 4.0;  // of a step
  const double feature_m = feature_steps * number_.step_m();
  const glm::dvec2 bay(bays_.at(at_m / feature_m), bays_.at(at_m / feature_m + 71.3));
  const glm::dvec2 place = glm::clamp((at_m - number_.corner_m()) / number_.step_m() + bays * bay,
                                      0.0, number_.samples() - 1.0);
  const glm::ivec2 first = glm::min(glm::ivec2(place), number_.samples() - 2);
  const glm::dvec2 part = place - glm::dvec2(first);
  Shares shares{.grass = 0.0};
  for (const glm::ivec2 corner : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
    const double weight =
        (corner.x == 1 ? part.x : 1.0 - part.x) * (corner.y == 1 ? part.y : 1.0 - part.y);
    const int number = number_.at(first.x + corner.x, first.y + corner.y);
    if (number < 0) {
      shares.grass += weight;
      continue;
    }
    const scene::CoverClass& kind = kinds_[static_cast<std::size_t>(number)];
    shares.grass += weight * kind.grass * (1.0 - kind.water);
    if (kind.albedo.empty()) continue;
    shares.coloured += weight;
    shares.albedo +=
        static_cast<float>(weight) * glm::vec3(kind.albedo[0], kind.albedo[1], kind.albedo[2]);
  }
  return shares;
}

std::optional<LandCover> read_land_cover(const scene::Terrain& terrain,
                                         const std::vector<scene::CoverClass>& classes,
                                         std::uint64_t seed) {
  if (terrain.cover.empty() || terrain.elevation.empty()) return std::nullopt;
  const QuietGdal quiet;
  const Raster elevation(terrain.elevation, terrain.system);
  const LocalSystem local = local_system(elevation, middle_of(terrain, elevation));
  const Raster raster = cover_raster(terrain);
  if (local.definition.empty() != (raster.system() == nullptr))
    raster.fail(
        "expected a coordinate system where terrain.elevation has one, and none where it has none");
  const ThinnedCells cells =
      thinned_cells(raster, cells_under(raster, local, terrain.size_m), most_cells);
  require_classes(raster, cells);
  const double side_m = cells.apart * cell_m(raster, local);
  const int samples =
      static_cast<int>(std::clamp(terrain.size_m / side_m + 1.0, 17.0, most_cells + 1.0));
  const std::map<int, int> indices = indices_of(classes);
  const auto number_of = [&](int cell) {
    if (cell < 0 || std::isnan(cells.block.values[static_cast<std::size_t>(cell)])) return -1;
    const auto found =
        indices.find(static_cast<int>(cells.block.values[static_cast<std::size_t>(cell)]));
    return found == indices.end() ? -1 : found->second;
  };
  return LandCover(
      by_place<int>(cells, raster, local, {{.size_m = terrain.size_m}, samples}, number_of),
      classes, seed);
}

std::optional<Lakes> with_covered_water(std::optional<Lakes> lakes, const LandCover& cover,
                                        const Heightfield& heights_m) {
  constexpr std::size_t least = 36;
  const GroundMap<int>& number = cover.number();
  Lakes covered{GroundMap<int>(number.samples(), number.square(), -1), {}};
  std::vector<River> rivers;
  for (Places& places : waters_of(cover)) {
    if (places.size() < least) continue;
    const std::vector<double> measured_m = heights_of(places, cover, heights_m);
    if (const auto level_m = level_of_lake(measured_m)) {
      const int lake = static_cast<int>(covered.levels_m.size());
      for (const glm::ivec2& at : places) covered.number.at(at.x, at.y) = lake;
      covered.levels_m.push_back(*level_m);
    } else if (auto levels_m = river_levels_m(places, measured_m, number.step_m())) {
      rivers.push_back({std::move(places), std::move(*levels_m)});
    }
  }
  if (!rivers.empty()) covered = with_rivers(covered, rivers);
  if (covered.levels_m.empty()) return lakes;
  return lakes ? joined(std::move(*lakes), covered) : std::move(covered);
}

}  // namespace wold::terrain
