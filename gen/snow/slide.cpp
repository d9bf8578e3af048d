#include "snow/slide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "terrain/relief.h"

namespace wold::snow {
namespace {

struct Neighbour {
  std::size_t index;
  double drop_m;
};

/// The neighbours whose ground is lower than that of (i, j), in a fixed order.
struct LowerNeighbours {
  std::array<Neighbour, 8> places;
  std::size_t count = 0;

  LowerNeighbours(const Heightfield& terrain, int i, int j) {
    const double height_m = terrain.at(i, j);
    for (int y = std::max(j - 1, 0); y <= std::min(j + 1, terrain.samples() - 1); ++y)
      for (int x = std::max(i - 1, 0); x <= std::min(i + 1, terrain.samples() - 1); ++x)
        if (const double drop_m = height_m - terrain.at(x, y); drop_m > 0.0)
          places[count++] = {static_cast<std::size_t>(y) * terrain.samples() + x, drop_m};
  }

  double drop_m() const {
    double sum = 0.0;
    for (std::size_t n = 0; n < count; ++n) sum += places[n].drop_m;
    return sum;
  }

  /// Drops of the snow's surface in place of the ground's, unless there are none.
  void add_snow(double depth_m, const std::vector<double>& depths_m) {
    LowerNeighbours surface = *this;
    for (std::size_t n = 0; n < count; ++n) {
      double& drop = surface.places[n].drop_m;
      drop = std::max(drop + depth_m - depths_m[places[n].index], 0.0);
    }
    if (surface.drop_m() > 0.0) *this = surface;
  }
};

}  // namespace

double most_depth_m(double slope_deg) {
  constexpr double gentle_deg = 10.0;
  if (slope_deg < gentle_deg) return std::numeric_limits<double>::infinity();
  return 3178.4 * std::pow(slope_deg, -1.998);
}

SnowSlide::SnowSlide(const Heightfield& terrain) : terrain_(terrain) {
  const auto side = static_cast<std::size_t>(terrain.samples());
  std::vector<float> limits_m(side * side);
  parallel_for(side, [&](std::size_t j) {
    const double y_m = static_cast<double>(j) * terrain.step_m();
    for (std::size_t i = 0; i < side; ++i)
      limits_m[j * side + i] = static_cast<float>(most_depth_m(
          terrain::slope_deg(terrain, static_cast<double>(i) * terrain.step_m(), y_m)));
  });
  for (std::size_t place = 0; place < limits_m.size(); ++place)
    if (std::isfinite(limits_m[place]))
      steep_.push_back({static_cast<std::uint32_t>(place), limits_m[place]});
  const std::vector<float>& heights_m = terrain_.values();
  std::stable_sort(steep_.begin(), steep_.end(), [&](const Place& a, const Place& b) {
    return heights_m[a.index] > heights_m[b.index];
  });
}

void SnowSlide::settle(SnowpackField& packs) const {
  for (const Place& place : steep_)
    if (packs.depth_m[place.index] > place.most_m) shed(packs, place);
}

void SnowSlide::shed(SnowpackField& packs, const Place& place) const {
  const std::size_t from = place.index;
  const auto side = static_cast<std::size_t>(terrain_.samples());
  LowerNeighbours below(terrain_, static_cast<int>(from % side), static_cast<int>(from / side));
  if (below.count == 0) return;
  below.add_snow(packs.depth_m[from], packs.depth_m);
  const double excess_m = packs.depth_m[from] - place.most_m;
  const double excess_mm = packs.water_mm[from] * excess_m / packs.depth_m[from];
  const double drop_m = below.drop_m();
  for (std::size_t n = 0; n < below.count; ++n) {
    const Neighbour& to = below.places[n];
    const double share = to.drop_m / drop_m;
    const double water_mm = packs.water_mm[to.index] + share * excess_mm;
    if (water_mm > 0.0)  // the surface is a mixture of both
      packs.age[to.index] += (packs.age[from] - packs.age[to.index]) * share * excess_mm / water_mm;
    packs.water_mm[to.index] = water_mm;
    packs.depth_m[to.index] += share * excess_m;
  }
  packs.water_mm[from] -= excess_mm;
  packs.depth_m[from] = place.most_m;
}

}  // namespace wold::snow
