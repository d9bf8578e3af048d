#include "terrain/worn_land.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/elementary.h"
#include "core/ground_map.h"
#include "core/interpolation.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "core/random.h"
#include "terrain/streams.h"

namespace wold::terrain {
namespace {

/// A tile, heights in any unit: what follows its last sample is its first one.
using Map = GroundMap<double>;

constexpr int finest_side = 512;  // samples of the finished tile

template <class Value>
Map filled(int side, const Value& value) {
  Map map(side, static_cast<double>(side - 1));
  parallel_for(static_cast<std::size_t>(side), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < side; ++i) map.at(i, j) = value(i, j);
  });
  return map;
}

/// A value that may lie a tile aside.
double around(const Map& map, int i, int j) {
  const int side = map.samples();
  return map.at((i + side) % side, (j + side) % side);
}

/// Without what is finer than about two holes: the filter 1 4 6 4 1 with holes between its samples
/// [Holschneider1989], along both axes.
Map blurred(const Map& map, int hole) {
  const auto along = [&](const Map& from, int east, int north) {
    return filled(from.samples(), [&](int i, int j) {
      const auto at = [&](int k) {
        return around(from, i + k * hole * east, j + k * hole * north);
      };
      return (6.0 * at(0) + 4.0 * (at(-1) + at(1)) + at(-2) + at(2)) / 16.0;
    });
  };
  return along(along(map, 1, 0), 0, 1);
}

/// Twice as many samples along a side.
Map doubled(const Map& map) {
  return filled(2 * map.samples(), [&](int i, int j) {
    const int x = i / 2, y = j / 2;
    return bilinear(map.at(x, y), around(map, x + 1, y), around(map, x, y + 1),
                    around(map, x + 1, y + 1), 0.5 * (i % 2), 0.5 * (j % 2));
  });
}

double mean(const Map& map) {
  double sum = 0.0;
  for (const double value : map.values()) sum += value;
  return sum / static_cast<double>(map.values().size());
}

/// Where rock rises, and how fast. It is uneven at all sizes, as rock is: on even slopes water
/// would run along the grid and never join.
class Belts {
 public:
  explicit Belts(std::uint64_t key)
      : belts_(random_bits({key, key_of("worn land"), 0, key_of("belts")}), 3, 0.9,
               WornLand::period),
        uneven_(random_bits({key, key_of("worn land"), 0, key_of("uneven")}), 5, 0.3,
                2 * WornLand::period) {}

  /// Deviations of the belts' field above the border of the lowlands.
  double above_lowlands(const glm::dvec2& at) const {
    constexpr double lowlands = -1.2;  // an eighth of the land
    return belts_.at(at) - lowlands;
  }
  /// In any unit.
  double rise(const glm::dvec2& at) const {
    constexpr double full = 1.5, deviation = 0.4;
    return glm::smoothstep(0.0, full, above_lowlands(at)) *
           math::exp(deviation * uneven_.at(2.0 * at));
  }

 private:
  Fbm belts_, uneven_;
};

/// How long streams wear a tile of a number of samples; see Incision.
struct Age {
  int side;
  double reach;
  int rounds;
};

/// The coarsest one comes to rest; finer ones get the small valleys.
constexpr std::array<Age, 4> ages = {{{finest_side / 8, 40.0, 20},
                                      {finest_side / 4, 10.0, 3},
                                      {finest_side / 2, 10.0, 3},
                                      {finest_side, 4.0, 2}}};

/// Streams that cut while rock rises and slopes creep, in turns, down to the lowlands.
void wear(Map& heights, const Belts& belts, const Age& age) {
  constexpr double creep = 0.1;  // how far to a blurred map in a round
  const auto place = [&](int i, int j) {
    return glm::dvec2(i, j) * (1.0 * WornLand::period / age.side);
  };
  const double reach = age.reach / age.rounds;
  const Map rise = filled(age.side, [&](int i, int j) { return reach * belts.rise(place(i, j)); });
  BaseLevel lowlands;
  for (int j = 0; j < age.side; ++j)
    for (int i = 0; i < age.side; ++i) lowlands.push_back(belts.above_lowlands(place(i, j)) <= 0.0);
  for (int round = 0; round < age.rounds; ++round) {
    carve(heights, rise, lowlands, {.reach = reach, .source_fraction = 4e-4, .steps = 3});
    const Map crept = blurred(heights, 1);
    for (std::size_t k = 0; k < lowlands.size(); ++k) {
      double& height = heights.values()[k];
      height = lowlands[k] ? 0.0 : std::lerp(height, crept.values()[k], creep);
    }
  }
}

/// Of mean 0 and deviation 1.
Map mountains(std::uint64_t key) {
  const Belts belts(key);
  Map heights(ages.front().side, ages.front().side - 1.0);
  for (const Age& age : ages) {
    if (heights.samples() < age.side) heights = doubled(heights);
    wear(heights, belts, age);
  }
  const double middle = mean(heights);
  double squares = 0.0;
  for (double& height : heights.values()) {
    height -= middle;
    squares += height * height;
  }
  const double deviation = std::sqrt(squares / static_cast<double>(heights.values().size()));
  for (double& height : heights.values()) height /= deviation;
  return heights;
}

/// Over its mean, of the land without its finest features.
Map steepness_of(const Map& heights) {
  Map steep = blurred(
      blurred(filled(heights.samples(),
                     [&](int i, int j) {
                       const double east = around(heights, i + 1, j) - around(heights, i - 1, j),
                                    north = around(heights, i, j + 1) - around(heights, i, j - 1);
                       return std::sqrt(east * east + north * north);
                     }),
              1),
      2);
  const double middle = mean(steep);
  for (double& value : steep.values()) value /= middle;
  return steep;
}

std::vector<float> tile_of(const Map& map) { return {map.values().begin(), map.values().end()}; }

}  // namespace

WornLand::WornLand(std::uint64_t key) {
  Map left = mountains(key);
  steepness_ = tile_of(steepness_of(left));
  for (int octave = octaves - 1; octave > 0; --octave) {
    Map coarse = blurred(left, 1 << (octaves - 1 - octave));
    for (std::size_t k = 0; k < left.values().size(); ++k) left.values()[k] -= coarse.values()[k];
    octaves_.push_back(tile_of(left));
    left = std::move(coarse);
  }
  octaves_.push_back(tile_of(left));
  std::ranges::reverse(octaves_);
  // Splines stay between their samples.
  for (const Tile& tile : octaves_) highest_.push_back(double{*std::ranges::max_element(tile)});
}

/// By quadratic B-splines, smooth across the samples.
double WornLand::between(const Tile& tile, const glm::dvec2& at) {
  constexpr double samples = 1.0 * finest_side / period;
  const glm::dvec2 place = samples * at, middle = glm::floor(place + 0.5);
  const auto weights = [](double from_middle) {
    const double low = 0.5 - from_middle, high = 0.5 + from_middle;
    return std::array{0.5 * low * low, 0.5 + low * high, 0.5 * high * high};
  };
  const auto wrapped = [](double k) {
    const double from = k - 1.0 - finest_side * std::floor((k - 1.0) / finest_side);
    const auto first = static_cast<std::size_t>(from);
    return std::array{first, (first + 1) % finest_side, (first + 2) % finest_side};
  };
  const auto of_column = weights(place.x - middle.x), of_row = weights(place.y - middle.y);
  const auto columns = wrapped(middle.x), rows = wrapped(middle.y);
  double sum = 0.0;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i)
      sum += of_row[j] * of_column[i] * double{tile[rows[j] * finest_side + columns[i]]};
  return sum;
}

double WornLand::height(int octave, const glm::dvec2& at) const {
  return between(octaves_.at(static_cast<std::size_t>(octave)), at);
}

double WornLand::steepness(const glm::dvec2& at) const { return between(steepness_, at); }

}  // namespace wold::terrain
