#include "terrain/water.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/between.h"
#include "core/interpolation.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

/// Of 0 and 1: a cell of two steps shows no corners any more.
constexpr int smoothing_passes = 2;

FactorMap wetness_of(const GroundMap<int>& number) {
  FactorMap wet(number.samples(), number.square());
  for (std::size_t i = 0; i < wet.values().size(); ++i)
    wet.values()[i] = number.values()[i] < 0 ? 0.0F : 1.0F;
  for (int pass = 0; pass < smoothing_passes; ++pass) smooth(wet);
  return wet;
}

/// Lakes one step wider, so that places near a shore know theirs.
void widen(GroundMap<int>& number) {
  const GroundMap<int> old = number;
  const int last = old.samples() - 1;
  for (int j = 0; j <= last; ++j)
    for (int i = 0; i <= last; ++i) {
      if (old.at(i, j) >= 0) continue;
      for (const glm::ivec2 side : {glm::ivec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const int x = std::clamp(i + side.x, 0, last), y = std::clamp(j + side.y, 0, last);
        number.at(i, j) = std::max(number.at(i, j), old.at(x, y));
      }
    }
}

FactorMap levels_of(Lakes lakes) {
  constexpr int around = 2 * smoothing_passes + 2;
  for (int step = 0; step < around; ++step) widen(lakes.number);
  FactorMap level_m(lakes.number.samples(), lakes.number.square());
  for (std::size_t i = 0; i < level_m.values().size(); ++i) {
    const int lake = lakes.number.values()[i];
    if (lake >= 0)
      level_m.values()[i] = static_cast<float>(lakes.levels_m[static_cast<std::size_t>(lake)]);
  }
  return level_m;
}

/// The number at the nearest step; -1 outside.
int number_at(const GroundMap<int>& number, const glm::dvec2& at_m) {
  if (!number.square().contains(at_m)) return -1;
  const glm::ivec2 nearest(glm::round((at_m - number.corner_m()) / number.step_m()));
  return number.at(nearest.x, nearest.y);
}

}  // namespace

Lakes finer(const Lakes& lakes, double step_m) {
  constexpr double most_samples = 4097.0;
  const Square& square = lakes.number.square();
  const double finest_m = std::min(lakes.number.step_m(), step_m);
  const auto samples =
      static_cast<int>(std::min(most_samples, std::ceil(square.size_m / finest_m) + 1.0));
  GroundMap<int> number(samples, square, -1);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i)
      number.at(i, j) = number_at(lakes.number, number.place_m(i, j));
  return {std::move(number), lakes.levels_m};
}

Lakes joined(const Lakes& first, const Lakes& others) {
  Lakes all = finer(first, others.number.step_m());
  for (int j = 0; j < all.number.samples(); ++j)
    for (int i = 0; i < all.number.samples(); ++i) {
      const int other = number_at(others.number, all.number.place_m(i, j));
      if (int& lake = all.number.at(i, j); lake < 0 && other >= 0) lake = first.count() + other;
    }
  all.levels_m.insert(all.levels_m.end(), others.levels_m.begin(), others.levels_m.end());
  return all;
}

Water::Water(Lakes lakes, std::uint64_t seed)
    : wet_(wetness_of(lakes.number)),
      level_m_(levels_of(std::move(lakes))),
      bays_{random_bits({seed, key_of("water"), 0, key_of("bays")}), /*octaves=*/7,
            /*hurst=*/0.8} {}

/// Above 0 in water, below 0 on land, -0.5 and 0.5 away from shores. Bays vanish there.
double Water::beyond_shore(const glm::dvec2& at_m) const {
  constexpr double bays = 0.11, highest = 2.2;
  const double wet{wet_.sample(at_m.x, at_m.y)};
  if (wet <= 0.0 || wet >= 1.0) return wet - 0.5;
  const double feature_m = 4.0 * wet_.step_m();
  const double bay = std::clamp(bays_.at(at_m / feature_m), -highest, highest);
  return wet - 0.5 + 4.0 * wet * (1.0 - wet) * bays * bay;
}

double Water::share(const glm::dvec2& at_m, double step_m) const {
  constexpr double steps_per_unit = 2.5;  // across a straight shore
  if (!wet_.square().contains(at_m)) return 0.0;
  const double unit_m = steps_per_unit * wet_.step_m();
  // From one half to the other: a coarser map has all of the fade that there is.
  const double across_m = std::clamp(step_m, 1e-6, unit_m);
  return std::clamp(0.5 + unit_m * beyond_shore(at_m) / across_m, 0.0, 1.0);
}

double Water::level_m(const glm::dvec2& at_m) const {
  const glm::dvec2 place = (at_m - level_m_.corner_m()) / level_m_.square().size_m;
  const auto samples = static_cast<std::size_t>(level_m_.samples());
  const Between x(place.x, samples), y(place.y, samples);
  const float of_lake_m = level_m_.at(static_cast<int>(x.first) + (x.part < 0.5F ? 0 : 1),
                                      static_cast<int>(y.first) + (y.part < 0.5F ? 0 : 1));
  // In a lake all are 0, whatever rounding makes of sums.
  const auto higher_m = [&](int i, int j) {
    return level_m_.at(static_cast<int>(x.first) + i, static_cast<int>(y.first) + j) - of_lake_m;
  };
  return double{of_lake_m} + double{bilinear(higher_m(0, 0), higher_m(1, 0), higher_m(0, 1),
                                             higher_m(1, 1), x.part, y.part)};
}

void Water::settle(Heightfield& heights_m) const {
  parallel_for(static_cast<std::size_t>(heights_m.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < heights_m.samples(); ++i) {
      const glm::dvec2 at_m = heights_m.place_m(i, j);
      if (!wet_.square().contains(at_m)) continue;
      const double own = glm::smoothstep(0.0, 0.5, -beyond_shore(at_m));
      if (own >= 1.0) continue;
      float& height_m = heights_m.at(i, j);
      height_m = static_cast<float>(std::lerp(level_m(at_m), double{height_m}, own));
    }
  });
}

}  // namespace wold::terrain
