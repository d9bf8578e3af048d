#include "cloud/detail.h"

#include <algorithm>
#include <cmath>

#include "cloud/procedural_texture.h"
#include "cloud/texture_noise.h"
#include "core/elementary.h"
#include "core/random.h"
#include "core/statistics.h"

namespace wold::cloud {
namespace {

constexpr int tile_features = 16;
constexpr int tile_px = 256;

/// noise(place in features, key, period) over one tile, without its mean.
template <class Noise>
std::shared_ptr<const PeriodicMap<float>> tile_of(std::uint64_t key, const Noise& noise) {
  auto tile = std::make_shared<PeriodicMap<float>>(tile_px, tile_px);
  for (int y = 0; y < tile_px; ++y)
    for (int x = 0; x < tile_px; ++x)
      tile->at(x, y) = static_cast<float>(noise(
          glm::dvec2(x + 0.5, y + 0.5) * (static_cast<double>(tile_features) / tile_px), key));
  subtract_mean(tile->values());
  return tile;
}

}  // namespace

Detail::Detail(const Recipe& recipe, int side_px, double cell_m, const glm::dvec2& period_m,
               std::uint64_t key) {
  const glm::ivec2 period(tile_features);
  if (recipe.trails.length > 0.0) {
    fibres_ = Fibres(recipe, octaves_in_map(recipe.masses, side_px), cell_m, period_m, key);
    max_ += fibres_.max();
  } else if (recipe.masses.weight != 0.0) {
    add(recipe.masses,
        tile_of(key ^ key_of("masses"),
                [&](const glm::dvec2& at, std::uint64_t own) { return perlin(at, own, period); }),
        side_px, cell_m, period_m, key ^ key_of("masses"));
  }
  if (recipe.billows.weight != 0.0)
    add(recipe.billows,
        tile_of(
            key ^ key_of("billows"),
            [&](const glm::dvec2& at, std::uint64_t own) { return billow_cell(at, own, period); }),
        side_px, cell_m, period_m, key ^ key_of("billows"));
}

void Detail::add(const Octaves& octaves, const std::shared_ptr<const PeriodicMap<float>>& tile,
                 int side_px, double cell_m, const glm::dvec2& period_m, std::uint64_t key) {
  const double highest = double{*std::ranges::max_element(tile->values())};
  for (int i = octaves_in_map(octaves, side_px); i < octaves.count; ++i) {
    const glm::dvec2 feature_m = cell_m / glm::dvec2(octaves.period) / math::exp2(1.0 * i);
    const glm::dvec2 tiles =
        glm::max(glm::round(period_m / (feature_m * double{tile_features})), glm::dvec2(1.0));
    const auto number = static_cast<std::uint64_t>(i);
    octaves_.push_back({tile,
                        tiles / period_m,
                        {random_uniform({key, key_of("detail x"), number}),
                         random_uniform({key, key_of("detail y"), number})},
                        std::min(feature_m.x, feature_m.y),
                        octaves.weight * math::pow(octaves.gain, i)});
    max_ += octaves_.back().height * std::max(highest, 0.0);
  }
}

double Detail::at(const glm::dvec2& place_m, double footprint_m) const {
  double sum = fibres_.at(place_m, footprint_m);
  for (const Octave& octave : octaves_) {
    const double seen = std::min(2.0 - 2.0 * footprint_m / octave.feature_m, 1.0);
    if (seen <= 0.0) continue;
    const glm::dvec2 at = place_m * octave.tiles_per_m + octave.shift;
    sum += seen * octave.height * octave.tile->sample(at.x, at.y);
  }
  return sum;
}

}  // namespace wold::cloud
