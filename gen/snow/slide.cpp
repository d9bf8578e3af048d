#include "snow/slide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/elementary.h"
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

double max_depth_m(double slope_deg) {
  constexpr double gentle_deg = 10.0;
  if (slope_deg < gentle_deg) return std::numeric_limits<double>::infinity();
  return 3178.4 * math::pow(slope_deg, -1.998);
}

FactorMap max_depths_m(const Heightfield& terrain) {
  FactorMap result(terrain.samples(), terrain.size_m());
  parallel_for(static_cast<std::size_t>(terrain.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < terrain.samples(); ++i)
      result.at(i, j) = static_cast<float>(
          max_depth_m(terrain::slope_deg(terrain, i * terrain.step_m(), j * terrain.step_m())));
  });
  return result;
}

void SnowSlide::settle(SnowpackField& packs) const {
  const std::vector<float>& max_m = max_m_.values();
  const auto is_lower = [&](std::size_t a, std::size_t b) {
    const float a_m = terrain_.values()[a], b_m = terrain_.values()[b];
    return a_m != b_m ? a_m < b_m : a > b;
  };
  // Snow only ever comes from higher ground, so a place has all it gets when its turn comes.
  std::vector<std::size_t> heap, overfed;
  for (std::size_t i = 0; i < max_m.size(); ++i)
    if (packs.depth_m[i] > max_m[i]) heap.push_back(i);
  std::make_heap(heap.begin(), heap.end(), is_lower);
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), is_lower);
    const std::size_t highest = heap.back();
    heap.pop_back();
    overfed.clear();
    shed(packs, highest, overfed);
    for (std::size_t place : overfed) {
      heap.push_back(place);
      std::push_heap(heap.begin(), heap.end(), is_lower);
    }
  }
}

void SnowSlide::shed(SnowpackField& packs, std::size_t from,
                     std::vector<std::size_t>& overfed) const {
  const auto side = static_cast<std::size_t>(terrain_.samples());
  LowerNeighbours below(terrain_, static_cast<int>(from % side), static_cast<int>(from / side));
  if (below.count == 0) return;
  below.add_snow(packs.depth_m[from], packs.depth_m);
  const std::vector<float>& max_m = max_m_.values();
  const double excess_m = packs.depth_m[from] - max_m[from];
  const double excess_mm = packs.water_mm[from] * excess_m / packs.depth_m[from];
  const double excess_fraction = excess_m / packs.depth_m[from];
  const double drop_m = below.drop_m();
  for (std::size_t n = 0; n < below.count; ++n) {
    const Neighbour& to = below.places[n];
    const double fraction = to.drop_m / drop_m;
    const double water_mm = packs.water_mm[to.index] + fraction * excess_mm;
    if (water_mm > 0.0)  // the surface is a mixture of both
      packs.age[to.index] +=
          (packs.age[from] - packs.age[to.index]) * fraction * excess_mm / water_mm;
    packs.water_mm[to.index] = water_mm;
    for (std::vector<double>* held : {&packs.liquid_mm, &packs.lacking_mm})
      if (!held->empty()) (*held)[to.index] += fraction * excess_fraction * (*held)[from];
    const double depth_m = packs.depth_m[to.index] + fraction * excess_m;
    if (depth_m > max_m[to.index] && packs.depth_m[to.index] <= max_m[to.index])
      overfed.push_back(to.index);
    packs.depth_m[to.index] = depth_m;
  }
  packs.water_mm[from] -= excess_mm;
  for (std::vector<double>* held : {&packs.liquid_mm, &packs.lacking_mm})
    if (!held->empty()) (*held)[from] *= 1.0 - excess_fraction;
  packs.depth_m[from] = max_m[from];
}

}  // namespace wold::snow
