#include "terrain/land_cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "core/quiet_gdal.h"
#include "core/random.h"
#include "core/samples_between.h"
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
template <class IsWater>
Places water_about(const glm::ivec2& first, const IsWater& is_water, GroundMap<int>& seen) {
  Places places = {first};
  seen.at(first.x, first.y) = 1;
  for (std::size_t next = 0; next < places.size(); ++next) {
    const glm::ivec2 place = places[next];
    each_neighbour(place, seen, [&](const glm::ivec2& at) {
      if (seen.at(at.x, at.y) != 0 || !is_water(at)) return;
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

constexpr std::size_t least_places = 36;
constexpr double most_uneven_m = 6.0;  // what is measured on level water

/// The level of water as level as a lake; a river falls. None where it is a river.
std::optional<double> level_of_lake(std::vector<double> heights_m) {
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

/// What is water in a cover.
class CoveredWater {
 public:
  CoveredWater(const LandCover& cover, const Heightfield& heights_m)
      : cover_(cover),
        heights_m_(heights_m),
        lakes_{GroundMap<int>(cover.number().samples(), cover.number().square(), -1), {}} {
    const auto is_water = [&](const glm::ivec2& at) { return cover.is_water(at.x, at.y); };
    for (const Places& places : waters(is_water)) {
      const std::vector<double> measured_m = heights_of(places, cover, heights_m);
      if (const auto level_m = level_of_lake(measured_m)) add_lake(places, measured_m, *level_m);
    }
    for (Places& places : waters([&](const glm::ivec2& at) {
           return is_water(at) && lakes_.number.at(at.x, at.y) < 0;
         }))
      add_river(std::move(places));
  }

  const Lakes& lakes() const { return lakes_; }
  const std::vector<River>& rivers() const { return rivers_; }

 private:
  /// What hangs together, place by place; a few cells are left out.
  template <class IsWater>
  std::vector<Places> waters(const IsWater& is_water) const {
    const GroundMap<int>& number = cover_.number();
    GroundMap<int> seen(number.samples(), number.square(), 0);
    std::vector<Places> all;
    for (int j = 0; j < number.samples(); ++j)
      for (int i = 0; i < number.samples(); ++i) {
        if (seen.at(i, j) != 0 || !is_water(glm::ivec2(i, j))) continue;
        Places places = water_about({i, j}, is_water, seen);
        if (places.size() >= least_places) all.push_back(std::move(places));
      }
    return all;
  }

  /// Without the rivers that join it, which are higher or lower.
  void add_lake(const Places& places, std::span<const double> measured_m, double level_m) {
    const int lake = static_cast<int>(lakes_.levels_m.size());
    lakes_.levels_m.push_back(level_m);
    for (std::size_t k = 0; k < places.size(); ++k)
      if (std::abs(measured_m[k] - level_m) <= most_uneven_m)
        lakes_.number.at(places[k].x, places[k].y) = lake;
  }

  void add_river(Places places) {
    auto levels_m =
        river_levels_m(places, heights_of(places, cover_, heights_m_), cover_.number().step_m());
    if (levels_m) rivers_.push_back({std::move(places), std::move(*levels_m)});
  }

  const LandCover& cover_;
  const Heightfield& heights_m_;
  Lakes lakes_;
  std::vector<River> rivers_;
};

/// Lakes with rivers between them, on a map with two steps or more to a cell of the rivers' if that
/// is not too large. Each place of a river is a lake of its own, as its neighbours stand about as
/// high. It is one and a half cells wide, and three steps at least: Water shows hardly anything
/// narrower.
Lakes with_rivers(const Lakes& lakes, const std::vector<River>& rivers,
                  const GroundMap<int>& cells) {
  Lakes all = finer(lakes, 0.5 * cells.step_m());
  const GroundGrid grid{all.number.square(), all.number.samples()};
  const double half_m = std::max(0.75 * cells.step_m(), 1.5 * grid.step_m());
  const auto paint = [&](const glm::dvec2& middle_m, int number) {
    const glm::dvec2 low_m = middle_m - half_m, high_m = middle_m + half_m;
    const glm::ivec2 rows = samples_between(low_m.y, high_m.y, grid.square.corner_m.y, grid);
    const glm::ivec2 columns = samples_between(low_m.x, high_m.x, grid.square.corner_m.x, grid);
    for (int j = rows[0]; j <= rows[1]; ++j)
      for (int i = columns[0]; i <= columns[1]; ++i)
        if (int& own = all.number.at(i, j); own < 0 || own >= lakes.count()) own = number;
  };
  for (const River& river : rivers) {
    const int first = all.count();
    for (std::size_t k = 0; k < river.places.size(); ++k)
      paint(cells.place_m(river.places[k].x, river.places[k].y), first + static_cast<int>(k));
    all.levels_m.insert(all.levels_m.end(), river.levels_m.begin(), river.levels_m.end());
  }
  return all;
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
  const CoveredWater covered(cover, heights_m);
  if (!covered.lakes().levels_m.empty())
    lakes = lakes ? joined(*lakes, covered.lakes()) : covered.lakes();
  if (covered.rivers().empty()) return lakes;
  return with_rivers(lakes ? *lakes : covered.lakes(), covered.rivers(), cover.number());
}

}  // namespace wold::terrain
