#include "terrain/boulders.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/random.h"
#include "terrain/relief.h"

namespace wold::terrain {
namespace {

constexpr double group_m = 40.0;
/// Share of its cell that a boulder covers on the mean, where there is one.
constexpr double mean_cover = 0.052;

constexpr int max_samples = 1025;  // of a map of where they are likely, along a side

std::uint64_t as_bits(int number) { return static_cast<std::uint64_t>(number); }

}  // namespace

Boulders::Boulders(const Heightfield& heights_m, const scene::Terrain& terrain, std::uint64_t seed,
                   const Scree* scree, std::shared_ptr<const Water> water,
                   std::shared_ptr<const Paths> paths)
    : key_(random_bits({seed, key_of("ground"), 0, key_of("boulders")})),
      water_(std::move(water)),
      paths_(std::move(paths)),
      likely_(std::min(heights_m.samples(), max_samples), heights_m.square()),
      groups_{random_bits({key_, key_of("groups"), 0, 0}), 4, 0.4} {
  constexpr double below_rock = 19.0, lie_deg = 30.0, roll_deg = 40.0;
  const double on_open_ground = terrain.boulders_per_hectare / cells_on_a_hectare();
  parallel_for(static_cast<std::size_t>(likely_.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < likely_.samples(); ++i) {
      const glm::dvec2 at_m = likely_.place_m(i, j);
      const double fallen =
          scree == nullptr ? 0.0 : below_rock * double{scree->likely().sample(at_m.x, at_m.y)};
      const double lies =
          1.0 - glm::smoothstep(lie_deg, roll_deg, slope_deg(heights_m, at_m.x, at_m.y));
      likely_.at(i, j) = static_cast<float>(on_open_ground * (1.0 + fallen) * lies);
    }
  });
}

double Boulders::cells_on_a_hectare() {
  constexpr double hectare_m2 = 1e4, counted_m = 1.0;
  double cells = 0.0;
  for (const Size& size : sizes)
    if (size.width_m >= counted_m) cells += hectare_m2 / (size.cell_m() * size.cell_m());
  return cells;
}

double Boulders::probability(const glm::dvec2& at_m) const {
  constexpr double most = 0.95, least = 0.03, uneven = 1.3;
  constexpr double mean = 1.166;  // of what is at least `least`, by the normal distribution
  const double likely{likely_.sample(at_m.x, at_m.y)};
  if (likely <= 0.0) return 0.0;
  return std::min(most, likely * std::max(least, 1.0 + uneven * groups_.at(at_m / group_m)) / mean);
}

std::vector<Boulders::Placed> Boulders::row_of(std::size_t size, const glm::ivec2& first, int count,
                                               const Wanted& wanted) const {
  constexpr double wet = 0.01;
  const Size& kind = sizes[size];
  std::vector<Placed> row;
  for (int i = 0; i < count; ++i) {
    const glm::ivec2 cell = first + glm::ivec2(i, 0);
    const auto draw = [&](std::uint64_t purpose) {
      return random_uniform({key_ + size, as_bits(cell.x), as_bits(cell.y), purpose});
    };
    const glm::dvec2 middle_m = (glm::dvec2(cell) + glm::dvec2(draw(1), draw(2))) * kind.cell_m();
    if (!likely_.square().contains(middle_m) || draw(0) >= probability(middle_m)) continue;
    const double width_m =
        kind.width_m / std::sqrt(1.0 - draw(3) * (1.0 - 1.0 / (spread * spread)));
    if (!wanted(middle_m, width_m)) continue;
    if (water_ && water_->share(middle_m, width_m) > wet) continue;
    if (paths_ && paths_->lead_past(middle_m, 0.5 * width_m)) continue;
    const std::uint64_t bits = random_bits({key_ + size, as_bits(cell.x), as_bits(cell.y), 4});
    row.push_back({cell, Boulder(middle_m, width_m, bits)});
  }
  return row;
}

std::vector<std::vector<Boulders::Placed>> Boulders::rows_of(std::size_t size,
                                                             const glm::ivec2& first,
                                                             const glm::ivec2& last,
                                                             const Wanted& wanted) const {
  std::vector<std::vector<Placed>> rows(
      static_cast<std::size_t>(std::max(0, last.y - first.y + 1)));
  parallel_for(rows.size(), [&](std::size_t row) {
    rows[row] =
        row_of(size, first + glm::ivec2(0, static_cast<int>(row)), last.x - first.x + 1, wanted);
  });
  return rows;
}

NearbyBoulders::Cells Boulders::cells_of(std::size_t size, const Square& square,
                                         std::vector<Boulder>& all) const {
  constexpr int around = 2;
  NearbyBoulders::Cells cells;
  cells.cell_m = sizes[size].cell_m();
  cells.first = glm::ivec2(glm::floor(square.corner_m / cells.cell_m)) - around;
  const glm::ivec2 last =
      glm::ivec2(glm::floor((square.corner_m + square.size_m) / cells.cell_m)) + around;
  cells.count = last - cells.first + 1;
  cells.boulder.assign(
      static_cast<std::size_t>(cells.count.x) * static_cast<std::size_t>(cells.count.y), -1);
  const auto all_wanted = [](const glm::dvec2&, double) { return true; };
  for (const std::vector<Placed>& row : rows_of(size, cells.first, last, all_wanted))
    for (const Placed& placed : row) {
      cells.boulder[cells.index(placed.cell)] = static_cast<std::int32_t>(all.size());
      all.push_back(placed.boulder);
    }
  return cells;
}

NearbyBoulders Boulders::nearby(const Square& square, double step_m) const {
  NearbyBoulders nearby;
  nearby.step_m_ = step_m;
  for (std::size_t size = 0; size < sizes.size(); ++size) {
    const double shown = shown_fraction(sizes[size].width_m, step_m);
    if (shown <= 0.0) continue;
    nearby.cells_.push_back(cells_of(size, square, nearby.boulders_));
    nearby.cells_.back().shown = shown;
  }
  return nearby;
}

std::vector<Boulder> Boulders::about(const glm::dvec2& at_m, double widths,
                                     const Wanted& wanted) const {
  const glm::dvec2 low_m = likely_.corner_m(), high_m = low_m + likely_.size_m();
  std::vector<Boulder> boulders;
  for (std::size_t size = 0; size < sizes.size(); ++size) {
    const double cell_m = sizes[size].cell_m(), far_m = widths * sizes[size].most_m();
    const auto cell_at = [&](const glm::dvec2& place_m) {
      return glm::ivec2(glm::floor(glm::clamp(place_m, low_m, high_m) / cell_m));
    };
    for (const std::vector<Placed>& row :
         rows_of(size, cell_at(at_m - far_m), cell_at(at_m + far_m), wanted))
      for (const Placed& placed : row) boulders.push_back(placed.boulder);
  }
  return boulders;
}

double Boulders::hidden_cover(const glm::dvec2& at_m, double step_m) const {
  double hidden = 0.0;
  for (const Size& size : sizes) hidden += 1.0 - shown_fraction(size.width_m, step_m);
  return hidden > 0.0 ? hidden * mean_cover * probability(at_m) : 0.0;
}

const Boulder* NearbyBoulders::in(const Cells& cells, const glm::ivec2& cell) const {
  const glm::ivec2 place = cell - cells.first;
  if (glm::any(glm::lessThan(place, glm::ivec2(0))) ||
      glm::any(glm::greaterThanEqual(place, cells.count)))
    return nullptr;
  const std::int32_t number = cells.boulder[cells.index(cell)];
  return number < 0 ? nullptr : &boulders_[static_cast<std::size_t>(number)];
}

template <class Visit>
void NearbyBoulders::visit(const Cells& cells, const glm::ivec2& first, int along,
                           const Visit& boulder_of) const {
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < along; ++i)
      if (const Boulder* boulder = in(cells, first + glm::ivec2(i, j))) boulder_of(*boulder);
}

NearbyBoulders::Rise NearbyBoulders::at(const glm::dvec2& at_m, double snow_m) const {
  constexpr double least_slope = 0.3;  // at a rim
  Rise rise;
  for (const Cells& cells : cells_) {
    // No boulder reaches farther than half a cell.
    const glm::ivec2 south_west(glm::floor(at_m / cells.cell_m - 0.5));
    visit(cells, south_west, 2, [&](const Boulder& boulder) {
      const auto [over_ground_m, gradient] = boulder.top(at_m);
      const double height_m = over_ground_m - snow_m;
      const double strip_m = step_m_ * std::max(glm::length(gradient), least_slope);
      const double cover =
          strip_m > 0.0 ? std::clamp(0.5 + height_m / strip_m, 0.0, 1.0) : double(height_m > 0.0);
      rise.cover = std::max(rise.cover, cells.shown * cover);
      if (height_m <= rise.height_m) return;
      rise.height_m = height_m;
      rise.gradient = cells.shown * gradient;
    });
  }
  return rise;
}

Boulder::Light NearbyBoulders::light_beside(const glm::dvec2& at_m, const glm::dvec3& to_sun,
                                            const glm::dvec2& ascent, double snow_m) const {
  constexpr int reach = 2;                  // of shadows, in cells
  constexpr double whole = 1.4, end = 2.0;  // in cells from a boulder: shadows fade between them
  Boulder::Light left;
  for (const Cells& cells : cells_) {
    const glm::ivec2 here(glm::floor(at_m / cells.cell_m));
    visit(cells, here - reach, 2 * reach + 1, [&](const Boulder& boulder) {
      const double far = glm::distance(at_m, boulder.middle_m()) / cells.cell_m;
      if (far >= end || boulder.top(at_m).height_m > snow_m) return;
      const Boulder::Light light = boulder.light_beside(at_m, to_sun, ascent, snow_m);
      left.sun *= std::lerp(1.0, light.sun, cells.shown * (1.0 - glm::smoothstep(whole, end, far)));
      left.sky *= std::lerp(1.0, light.sky, cells.shown);
    });
  }
  return left;
}

}  // namespace wold::terrain
