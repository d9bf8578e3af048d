#include "cloud/procedural_texture.h"

#include <algorithm>

#include "cloud/texture_noise.h"
#include "cloud/trails.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::cloud {
namespace {

/// Sum of octaves; `noise` takes a place in features, a key and the period.
template <class Noise>
double sum_of(const Octaves& octaves, const glm::dvec2& place, std::uint64_t key,
              const Noise& noise) {
  double sum = 0.0, height = 1.0;
  glm::ivec2 period = octaves.period;
  for (int octave = 0; octave < octaves.count; ++octave) {
    const std::uint64_t own =
        random_bits({key, key_of("octave"), static_cast<std::uint64_t>(octave)});
    // Shifted by a part of a feature that is exact in binary: octaves' lattices do not coincide.
    const glm::dvec2 shift(static_cast<double>(own & 15U) / 16.0,
                           static_cast<double>(own >> 4 & 15U) / 16.0);
    sum += height * noise(place * glm::dvec2(period) + shift, own, period);
    height *= octaves.gain;
    period *= 2;
  }
  return sum;
}

double thermals_at(const Thermals& thermals, const glm::dvec2& place, std::uint64_t key) {
  return dome_noise(place * glm::dvec2(thermals.period), key, thermals.period, thermals.spread);
}

glm::dvec2 displaced(const Recipe& recipe, const glm::dvec2& place, std::uint64_t key) {
  if (recipe.warp == 0.0) return place;
  const Octaves octaves = {1.0, recipe.warp_period, 3, 0.5};
  return place + recipe.warp * glm::dvec2(sum_of(octaves, place, key ^ key_of("east"), perlin),
                                          sum_of(octaves, place, key ^ key_of("north"), perlin));
}

}  // namespace

int octaves_in_map(const Octaves& octaves, int side_px) {
  constexpr double min_px_per_feature = 3.0;
  int features = std::max(octaves.period.x, octaves.period.y);
  int held = 1;
  for (features *= 2; held < octaves.count && features * min_px_per_feature <= side_px; ++held)
    features *= 2;
  return held;
}

double procedural_field_at(const Recipe& recipe, const glm::dvec2& place, std::uint64_t key) {
  const glm::dvec2 at = displaced(recipe, place, key);
  double field = 0.0;
  if (recipe.thermals.weight != 0.0)
    field += recipe.thermals.weight * thermals_at(recipe.thermals, at, key ^ key_of("thermals"));
  if (recipe.masses.weight != 0.0)
    field += recipe.masses.weight * sum_of(recipe.masses, at, key ^ key_of("masses"), perlin);
  if (recipe.billows.weight != 0.0)
    field +=
        recipe.billows.weight * sum_of(recipe.billows, at, key ^ key_of("billows"), billow_cell);
  return field;
}

PeriodicMap<float> procedural_field(const Recipe& recipe, int side_px, std::uint64_t key) {
  PeriodicMap<float> field(side_px, side_px);
  parallel_for(static_cast<std::size_t>(side_px), [&](std::size_t y) {
    for (int x = 0; x < side_px; ++x) {
      const glm::dvec2 place((x + 0.5) / side_px, (static_cast<double>(y) + 0.5) / side_px);
      field.at(x, static_cast<int>(y)) =
          static_cast<float>(procedural_field_at(recipe, place, key));
    }
  });
  return recipe.trails.length > 0.0 ? trailing(field, recipe.trails, key ^ key_of("trails"))
                                    : field;
}

}  // namespace wold::cloud
