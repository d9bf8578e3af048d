#include "cloud/fibres.h"

#include <algorithm>
#include <cmath>

#include "cloud/box_filter.h"
#include "cloud/procedural_texture.h"
#include "core/elementary.h"
#include "core/statistics.h"

namespace wold::cloud {
namespace {

constexpr int tile_px = 576;
/// Of the coarsest octave, across a tile.
constexpr int tile_features = 24;
/// Longer trails, in tiles, would meet themselves at the tile's other side.
constexpr double longest_trail = 0.25;

/// Of fine heads over that of all of them: a choice, made by looking at filaments.
constexpr double contrast = 1.7;

/// A texture of a tile's size, of the octaves that are not held.
Recipe finer(const Recipe& recipe, int held, double tiles_per_cell) {
  Recipe fine;
  const Octaves& all = recipe.masses;
  fine.masses = {all.weight * math::pow(all.gain, held), glm::ivec2(tile_features),
                 all.count - held, all.gain};
  fine.masses.count = octaves_in_map(fine.masses, tile_px);
  fine.trails = recipe.trails;
  fine.trails.contrast *= contrast;
  fine.trails.length = std::min(recipe.trails.length * tiles_per_cell, longest_trail);
  return fine;
}

}  // namespace

Fibres::Fibres(const Recipe& recipe, int held, double cell_m, const glm::dvec2& period_m,
               std::uint64_t key) {
  if (held >= recipe.masses.count) return;
  const int features = std::max(recipe.masses.period.x, recipe.masses.period.y);
  const double tiles_per_cell = features * math::exp2(1.0 * held) / tile_features;
  const glm::dvec2 tiles = glm::max(glm::round(period_m / cell_m * tiles_per_cell), 1.0);
  tiles_per_m_ = tiles / period_m;
  pixel_m_ = 1.0 / std::max(tiles_per_m_.x, tiles_per_m_.y) / tile_px;
  PeriodicMap<float> field = procedural_field(finer(recipe, held, tiles_per_cell), tile_px, key);
  subtract_mean(field.values());
  max_ = std::max(double{*std::ranges::max_element(field.values())}, 0.0);
  tiles_ = with_halves(std::move(field));
}

double Fibres::at(const glm::dvec2& place_m, double footprint_m) const {
  if (tiles_.empty()) return 0.0;
  const glm::dvec2 at = place_m * tiles_per_m_;
  const double level = math::log2(std::max(footprint_m / pixel_m_, 1.0));
  const auto fine = static_cast<std::size_t>(level);
  if (fine >= tiles_.size()) return 0.0;
  const double coarser = fine + 1 < tiles_.size() ? tiles_[fine + 1].sample(at.x, at.y) : 0.0;
  return std::lerp(tiles_[fine].sample(at.x, at.y), coarser, level - static_cast<double>(fine));
}

}  // namespace wold::cloud
