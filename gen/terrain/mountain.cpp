#include "terrain/mountain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/elementary.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "core/random.h"
#include "terrain/creep.h"
#include "terrain/erosion.h"
#include "terrain/fractal_relief.h"
#include "terrain/streams.h"

namespace wold::terrain {
namespace {

// Places and lengths here are fractions of the map's side.
constexpr glm::dvec2 summit(0.52, 0.62);
constexpr double meadow_end = 0.15;
constexpr double meadow_rise = 0.04;     // of the mountain's height
constexpr double creep_fraction = 1e-5;  // of the side squared, per reach

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Keyed irregularity of the mountain's plan: a place near `at`. The summit stays in its place.
glm::dvec2 displaced(const glm::dvec2& at, std::uint64_t seed, double feature, double deviation) {
  const Fbm east{random_bits({seed, key_of("mountain"), 0, key_of("east")}), 4, 0.8};
  const Fbm north{random_bits({seed, key_of("mountain"), 0, key_of("north")}), 4, 0.8};
  const double amplitude = deviation * smooth_step(0.0, feature, glm::distance(at, summit));
  return at + amplitude * glm::dvec2(east.at(at / feature), north.at(at / feature));
}

/// 0 at the summit, 1 at the foot: a rounded square that reaches from the meadow to the borders.
double way_down(const glm::dvec2& at) {
  constexpr double roundness = 2.5;
  const glm::dvec2 from = at - summit;
  const double across = from.x < 0.0 ? summit.x : 1.0 - summit.x;
  const double along = from.y < 0.0 ? summit.y - meadow_end : 1.0 - summit.y;
  return math::pow(math::pow(std::abs(from.x) / across, roundness) +
                       math::pow(std::abs(from.y) / along, roundness),
                   1.0 / roundness);
}

/// The body without valleys: 1 at the summit, 0 in the meadow and at the borders. However its plan
/// is displaced, its foot stays within the rounded square.
double body(const glm::dvec2& at, std::uint64_t seed) {
  const double above = std::max(0.0, 1.0 - way_down(displaced(at, seed, 0.35, 0.06)));
  return smooth_step(0.0, 0.35, 1.0 - way_down(at)) * math::pow(above, 1.2);
}

/// How fast rock rises, in any unit. It is uneven at all sizes, as rock is: on even slopes water
/// would run along the grid and never join.
double rise(const glm::dvec2& at, std::uint64_t seed) {
  constexpr double feature = 0.08;
  constexpr double deviation = 0.3;
  const Fbm uneven{random_bits({seed, key_of("mountain"), 0, key_of("uneven")}), 5, 0.3};
  return body(at, seed) * math::exp(deviation * uneven.at(at / feature));
}

template <class Value>
GroundMap<double> filled(int samples, double size_m, const Value& value) {
  GroundMap<double> map(samples, size_m);
  parallel_for(static_cast<std::size_t>(samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < samples; ++i) map.at(i, j) = value(glm::dvec2(i, j) / (samples - 1.0));
  });
  return map;
}

/// Streams cut and slopes creep while rock rises by `uplift`. Heights have no scale: both laws are
/// linear.
void erode(GroundMap<double>& heights, const GroundMap<double>& uplift, const Incision& incision) {
  const double side_m = heights.size_m();
  carve(heights, uplift, incision);
  creep(heights, creep_fraction * incision.reach * side_m * side_m);
}

/// Rock rises while it is worn, in turns.
void grow(GroundMap<double>& heights, std::uint64_t seed, double reach, int rounds) {
  const double part = reach / rounds;
  const auto uplift = filled(heights.samples(), heights.size_m(),
                             [&](const glm::dvec2& at) { return part * rise(at, seed); });
  for (int round = 0; round < rounds; ++round)
    erode(heights, uplift, {.reach = part, .source_fraction = 1e-3, .steps = 3});
}

/// 0 on the map's border, 1 farther than `width` from it.
double inside(const glm::dvec2& at, double width) {
  const glm::dvec2 from_border = glm::min(at, 1.0 - at);
  return smooth_step(0.0, width, std::min(from_border.x, from_border.y));
}

/// Land rises again by what was worn off about it, as far as the Earth's crust is stiff; not at the
/// border, whose level stays.
void rebound(GroundMap<double>& heights, const GroundMap<double>& before) {
  constexpr double stiffness = 0.06;  // deviation of the bell that a load bends
  const double side_m = heights.size_m();
  GroundMap<double> worn = before;
  for (std::size_t k = 0; k < worn.values().size(); ++k) worn.values()[k] -= heights.values()[k];
  creep(worn, 0.5 * stiffness * stiffness * side_m * side_m);
  for (int j = 0; j < worn.samples(); ++j)
    for (int i = 0; i < worn.samples(); ++i)
      heights.at(i, j) +=
          worn.at(i, j) * inside(glm::dvec2(i, j) / (worn.samples() - 1.0), 2.0 * stiffness);
}

/// Streams cut spurs and small valleys into the land, whose body stays as it is.
void wear(GroundMap<double>& heights, double reach, double source_fraction) {
  constexpr int rounds = 2;
  const GroundMap<double> no_uplift(heights.samples(), heights.size_m());
  for (int round = 0; round < rounds; ++round) {
    const GroundMap<double> before = heights;
    erode(heights, no_uplift,
          {.reach = reach / rounds, .source_fraction = source_fraction, .steps = 3});
    rebound(heights, before);
  }
}

/// The place of the highest sample, in sides.
glm::dvec2 highest(const GroundMap<double>& map) {
  const auto top = std::max_element(map.values().begin(), map.values().end());
  const auto place = static_cast<int>(top - map.values().begin());
  return glm::dvec2(place % map.samples(), place / map.samples()) / (map.samples() - 1.0);
}

/// What few samples cannot have is evened out: of waves two steps long a fifth is left, with what
/// slopes have crept.
void even_out(GroundMap<double>& map, int samples) {
  const double step_m = map.size_m() / (samples - 1.0);
  const double crept_m2 = creep_fraction * map.size_m() * map.size_m();
  const double wanted_m2 = 0.16 * step_m * step_m;
  if (wanted_m2 > crept_m2) creep(map, wanted_m2 - crept_m2);
}

GroundMap<double> resampled(const GroundMap<double>& map, int samples) {
  return filled(samples, map.size_m(), [&](const glm::dvec2& at) {
    return map.sample(at.x * map.size_m(), at.y * map.size_m());
  });
}

/// The map with more samples, drawn so that its highest point comes to the summit's place, and bent
/// a little: water on a coarse grid leaves straight slopes that face the eight neighbours.
GroundMap<double> bent(const GroundMap<double>& map, std::uint64_t seed, int samples) {
  const glm::dvec2 aside = highest(map) - summit;
  return filled(samples, map.size_m(), [&](const glm::dvec2& at) {
    const double drawn = smooth_step(0.0, 1.0, 1.0 - way_down(at));
    const glm::dvec2 from = displaced(at, seed, 0.1, 0.012) + drawn * aside;
    return map.sample(from.x * map.size_m(), from.y * map.size_m());
  });
}

/// Scales the heights so that the highest is `height_m`; level ground stays.
void raise_to(GroundMap<double>& heights_m, double height_m) {
  const double highest_m = *std::max_element(heights_m.values().begin(), heights_m.values().end());
  if (highest_m <= 0.0) return;
  for (double& at_m : heights_m.values()) at_m *= height_m / highest_m;
}

/// Streams alone would cut the main valleys down to the borders' level right into the heart of the
/// mountain; its body lifts them there. Then they cut into finer and finer grids.
GroundMap<double> massif(const scene::Terrain& terrain, std::uint64_t seed) {
  constexpr int coarse = 129;
  constexpr double body_fraction = 0.5;
  auto heights =
      filled(coarse, terrain.size_m, [&](const glm::dvec2& at) { return rise(at, seed); });
  grow(heights, seed, 40.0, 20);
  raise_to(heights, 1.0 - body_fraction);
  for (int j = 0; j < coarse; ++j)
    for (int i = 0; i < coarse; ++i)
      heights.at(i, j) += body_fraction * body(glm::dvec2(i, j) / (coarse - 1.0), seed);
  heights = resampled(heights, 257);
  wear(heights, 2.0, 5e-4);
  heights = bent(heights, seed, 513);
  wear(heights, 1.0, 3e-4);
  even_out(heights, terrain.samples);
  heights = resampled(heights, terrain.samples);
  carve(heights, {.reach = terrain.streams, .source_fraction = 3e-4, .steps = 6});
  return heights;
}

/// The low ground rises northwards from the south border, over the meadow and a little beyond.
void tilt_meadow(GroundMap<double>& heights_m, double rise_m) {
  for (int j = 0; j < heights_m.samples(); ++j) {
    const double north = j / (heights_m.samples() - 1.0);
    for (int i = 0; i < heights_m.samples(); ++i)
      heights_m.at(i, j) += rise_m * smooth_step(0.0, 2.0 * meadow_end, north);
  }
}

}  // namespace

Heightfield make_mountain(const scene::Terrain& terrain, std::uint64_t seed) {
  GroundMap<double> heights_m = massif(terrain, seed);
  raise_to(heights_m, terrain.hill_height_m);
  tilt_meadow(heights_m, meadow_rise * terrain.hill_height_m);
  add_fractal_relief(heights_m, terrain, seed, terrain.relief_m, terrain.relief_feature_m);
  slide(heights_m, terrain.talus_deg, terrain.erosion_steps);
  raise_to(heights_m, terrain.hill_height_m);
  return crept(std::move(heights_m));
}

}  // namespace wold::terrain
