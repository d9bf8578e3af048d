#include "cloud/texture_set.h"

#include <algorithm>
#include <cmath>

#include "cloud/picture_texture.h"
#include "cloud/procedural_texture.h"
#include "cloud/ranks.h"
#include "core/curve.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::cloud {
namespace {

constexpr int finest_procedural_px = 512;
/// Thicker than this nobody sees through; optical depth 5.3.
constexpr double max_opacity = 0.995;

std::vector<float> sampled(const Curve& curve) {
  std::vector<float> values(profile_steps + 1);
  for (int i = 0; i <= profile_steps; ++i)
    values[static_cast<std::size_t>(i)] =
        static_cast<float>(curve(static_cast<double>(i) / profile_steps));
  return values;
}

/// 1 over the slope of the field by rank, from the field's means over equal steps of rank.
std::vector<float> slopes(const std::vector<PeriodicMap<float>>& fields,
                          const std::vector<PeriodicMap<float>>& ranks) {
  std::vector<double> sums(slope_steps), counts(slope_steps);
  for (std::size_t map = 0; map < fields.size(); ++map)
    for (std::size_t i = 0; i < fields[map].values().size(); ++i) {
      const auto step = static_cast<std::size_t>(ranks[map].values()[i] * slope_steps);
      sums[step] += fields[map].values()[i];
      counts[step] += 1.0;
    }
  std::vector<float> slopes(slope_steps + 1);
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const std::size_t high = std::clamp<std::size_t>(i, 1, slope_steps - 1), low = high - 1;
    const double rise = sums[high] / counts[high] - sums[low] / counts[low];
    // Not a number where too few pixels leave a step empty.
    slopes[i] = rise > 0.0 ? static_cast<float>(1.0 / (slope_steps * rise)) : 0.0F;
  }
  return slopes;
}

/// About as long a side, with halves: trails look far heads up in them.
int halvable(int side_px) {
  constexpr int multiple = 16;
  return side_px > multiple ? side_px / multiple * multiple : side_px;
}

TextureSet made_textures(Recipe recipe, int side_px, std::uint64_t key) {
  side_px = std::min(side_px, finest_procedural_px);
  if (recipe.trails.length > 0.0) side_px = halvable(side_px);
  recipe.masses.count = octaves_in_map(recipe.masses, side_px);
  recipe.billows.count = octaves_in_map(recipe.billows, side_px);
  std::vector<PeriodicMap<float>> fields;
  for (std::uint64_t i = 0; i < procedural_textures; ++i)
    fields.push_back(
        procedural_field(recipe, side_px, random_bits({key, key_of("cloud texture"), i})));
  std::vector<PeriodicMap<float>> ranks = ranked(fields);
  std::vector<float> rank_per_field = slopes(fields, ranks);
  // Where patches count as well the field counts for less.
  const double of_field = 1.0 / std::sqrt(1.0 + recipe.patches.weight * recipe.patches.weight);
  for (float& slope : rank_per_field) slope *= static_cast<float>(of_field);
  return {std::move(ranks),
          sampled(Curve(recipe.profile)),
          recipe.cover,
          recipe.opacity,
          recipe.patches,
          side_px,
          std::move(rank_per_field)};
}

double optical_depth(double opacity) { return -math::log1p(-std::min(opacity, max_opacity)); }

/// Quantiles of the pictures' optical depths, over the largest.
std::vector<float> profile_of(const std::vector<PeriodicMap<float>>& opacities) {
  std::vector<float> sorted;
  for (const PeriodicMap<float>& map : opacities)
    sorted.insert(sorted.end(), map.values().begin(), map.values().end());
  std::ranges::sort(sorted);
  const double densest = optical_depth(sorted.back());
  std::vector<float> profile(profile_steps + 1);
  for (std::size_t i = 0; i < profile.size(); ++i) {
    // Pixel j has the rank (j + 1/2) / n.
    const std::size_t place = std::min(i * sorted.size() / profile_steps, sorted.size() - 1);
    profile[i] = densest > 0.0 ? static_cast<float>(optical_depth(sorted[place]) / densest) : 0.0F;
  }
  return profile;
}

TextureSet picture_textures(const std::vector<std::string>& paths, int side_px) {
  std::vector<PeriodicMap<float>> opacities;
  opacities.reserve(paths.size());
  for (const std::string& path : paths) opacities.push_back(picture_opacity(path, side_px));
  float densest = 0.0F;
  for (const PeriodicMap<float>& map : opacities)
    densest = std::max(densest, *std::ranges::max_element(map.values()));
  return {ranked(opacities),
          profile_of(opacities),
          1.0,
          std::min(static_cast<double>(densest), max_opacity),
          {},
          0,
          {}};
}

/// Steps over three lengths of decay.
constexpr int smear_steps = 48;
constexpr double decay_lengths = 3.0;
constexpr double longest_decay = 0.1;  ///< in textures
constexpr double detail_decay = 0.12;  ///< of the decay: details are torn, not washed out
constexpr double detail_weight = 0.35;

/// Mean of the field up the wind, with weights that fall by e over `decay`.
double mean_upwind(const PeriodicMap<float>& field, const glm::dvec2& place,
                   const glm::dvec2& decay) {
  double sum = 0.0, weights = 0.0;
  for (int step = 0; step <= smear_steps; ++step) {
    const double lengths = decay_lengths * step / smear_steps;
    const double weight = math::exp(-lengths);
    const glm::dvec2 from = place - decay * lengths;
    sum += weight * field.sample(from.x, from.y);
    weights += weight;
  }
  return sum / weights;
}

PeriodicMap<float> drawn_out(const PeriodicMap<float>& field, const glm::dvec2& decay) {
  PeriodicMap<float> result(field.width(), field.height());
  parallel_for(static_cast<std::size_t>(field.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < field.width(); ++x) {
      const glm::dvec2 place((x + 0.5) / field.width(), (y + 0.5) / field.height());
      result.at(x, y) =
          static_cast<float>(mean_upwind(field, place, decay) +
                             detail_weight * mean_upwind(field, place, detail_decay * decay));
    }
  });
  return result;
}

}  // namespace

TextureSet textures_of(const scene::CloudLayer& layer, const Recipe& recipe, int side_px,
                       std::uint64_t key) {
  TextureSet textures = layer.textures.empty() ? made_textures(recipe, side_px, key)
                                               : picture_textures(layer.textures, side_px);
  textures.cover = layer.cover.value_or(textures.cover);
  textures.densest_opacity = layer.opacity.value_or(textures.densest_opacity);
  return textures;
}

TextureSet sheared(const TextureSet& textures, double heading_rad, double shear) {
  if (shear <= 0.0) return textures;
  const glm::dvec2 downwind(math::sin(heading_rad), math::cos(heading_rad));
  std::vector<PeriodicMap<float>> fields;
  for (const PeriodicMap<float>& map : textures.ranks)
    fields.push_back(drawn_out(map, downwind * (shear * longest_decay)));
  TextureSet result = textures;
  result.ranks = ranked(fields);
  return result;
}

}  // namespace wold::cloud
