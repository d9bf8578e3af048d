#include "cloud/texture_set.h"

#include <algorithm>
#include <cmath>

#include "cloud/picture_texture.h"
#include "cloud/procedural_texture.h"
#include "cloud/ranks.h"
#include "core/curve.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::cloud {
namespace {

constexpr int finest_procedural_px = 512;
/// Thicker than this nobody sees through; optical depth 5.3.
constexpr double most_opacity = 0.995;

std::vector<float> sampled(const Curve& curve) {
  std::vector<float> values(profile_steps + 1);
  for (int i = 0; i <= profile_steps; ++i)
    values[static_cast<std::size_t>(i)] =
        static_cast<float>(curve(static_cast<double>(i) / profile_steps));
  return values;
}

TextureSet made_textures(const Recipe& recipe, int side_px, std::uint64_t key) {
  std::vector<PeriodicMap<float>> fields;
  for (std::uint64_t i = 0; i < procedural_textures; ++i)
    fields.push_back(procedural_field(recipe, std::min(side_px, finest_procedural_px),
                                      random_bits({key, key_of("cloud texture"), i})));
  return {ranked(fields), sampled(Curve(recipe.profile)), recipe.cover, recipe.opacity};
}

double optical_depth(double opacity) { return -std::log1p(-std::min(opacity, most_opacity)); }

/// Quantiles of the pictures' optical depths, over the largest.
std::vector<float> profile_of(const std::vector<PeriodicMap<float>>& opacities) {
  std::vector<float> sorted;
  for (const PeriodicMap<float>& map : opacities)
    sorted.insert(sorted.end(), map.values().begin(), map.values().end());
  std::ranges::sort(sorted);
  const double densest = optical_depth(sorted.back());
  std::vector<float> profile(profile_steps + 1);
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const std::size_t place = i * (sorted.size() - 1) / profile_steps;
    profile[i] = densest > 0.0 ? static_cast<float>(optical_depth(sorted[place]) / densest) : 0.0F;
  }
  return profile;
}

TextureSet picture_textures(const std::vector<std::string>& paths, int side_px) {
  std::vector<PeriodicMap<float>> opacities;
  for (const std::string& path : paths) opacities.push_back(picture_opacity(path, side_px));
  float densest = 0.0F;
  for (const PeriodicMap<float>& map : opacities)
    densest = std::max(densest, *std::ranges::max_element(map.values()));
  return {ranked(opacities), profile_of(opacities), 1.0,
          std::min(static_cast<double>(densest), most_opacity)};
}

/// Trapezoidal weights over three lengths of decay.
constexpr int smear_steps = 48;
constexpr double decay_lengths = 3.0;
constexpr double longest_decay = 0.1;  ///< in textures

PeriodicMap<float> smeared(const PeriodicMap<float>& map, const glm::dvec2& downwind,
                           double decay) {
  PeriodicMap<float> result(map.width(), map.height());
  parallel_for(static_cast<std::size_t>(map.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < map.width(); ++x) {
      const glm::dvec2 place((x + 0.5) / map.width(), (y + 0.5) / map.height());
      double sum = 0.0;
      for (int step = 0; step <= smear_steps; ++step) {
        const double lengths = decay_lengths * step / smear_steps;
        const glm::dvec2 from = place - downwind * (decay * lengths);
        sum += std::exp(-lengths) * map.sample(from.x, from.y);
      }
      result.at(x, y) = static_cast<float>(sum);
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
  const glm::dvec2 downwind(std::sin(heading_rad), std::cos(heading_rad));
  std::vector<PeriodicMap<float>> drawn_out;
  for (const PeriodicMap<float>& map : textures.ranks)
    drawn_out.push_back(smeared(map, downwind, shear * longest_decay));
  TextureSet result = textures;
  result.ranks = ranked(drawn_out);
  return result;
}

}  // namespace wold::cloud
