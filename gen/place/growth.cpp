#include "place/growth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/elementary.h"
#include "core/image.h"
#include "core/interpolation.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "core/random.h"
#include "terrain/relief.h"

namespace wold::place {
namespace {

/// The user's picture over the terrain's square, row 0 in the north.
class Mask {
 public:
  Mask(const std::string& path, double size_m) : picture_(read_image(path)), size_m_(size_m) {}

  /// Mean of the colour channels at a place, in [0, 1]; what is no number counts as black.
  double at(const glm::dvec2& at_m) const {
    const double x = at_m.x / size_m_ * picture_.width - 0.5;
    const double y = (1.0 - at_m.y / size_m_) * picture_.height - 0.5;
    const double left = std::floor(x);
    const double top = std::floor(y);
    const auto value = [&](int right, int below) {
      return level(static_cast<int>(left) + right, static_cast<int>(top) + below);
    };
    const double mean =
        bilinear(value(0, 0), value(1, 0), value(0, 1), value(1, 1), x - left, y - top);
    return std::clamp(mean, 0.0, 1.0);
  }

 private:
  double level(int x, int y) const {
    const float* pixel =
        picture_.pixel(std::clamp(x, 0, picture_.width - 1), std::clamp(y, 0, picture_.height - 1));
    const int colours = picture_.channels < 3 ? 1 : 3;
    double sum = 0.0;
    for (int c = 0; c < colours; ++c) sum += double{pixel[c]} / colours;
    return std::isfinite(sum) ? sum : 0.0;
  }

  Image picture_;
  double size_m_;
};

/// From 1 to 0 while `value` rises by `width` about `limit`.
double below(double value, double limit, double width) {
  return 1.0 - glm::smoothstep(limit - width / 2.0, limit + width / 2.0, value);
}

/// Probability that grass grows, by the scene's limits.
class Limits {
 public:
  Limits(const scene::Growth& growth, const Heightfield& terrain)
      : growth_(growth), terrain_(terrain) {
    if (!growth.mask.empty()) mask_.emplace(growth.mask, terrain.size_m());
  }

  double probability(const glm::dvec2& at_m) const {
    constexpr double slope_strip_deg = 8.0;
    const double height_m = double{terrain_.sample(at_m.x, at_m.y)};
    const double height_strip_m = growth_.feature_m;
    double p = growth_.cover;
    if (growth_.steepest_deg < 90.0)
      p *= below(terrain::slope_deg(terrain_, at_m.x, at_m.y), growth_.steepest_deg,
                 slope_strip_deg);
    p *= below(height_m, growth_.highest_m, height_strip_m);
    p *= below(-height_m, -growth_.lowest_m, height_strip_m);
    return mask_ ? p * mask_->at(at_m) : p;
  }

 private:
  const scene::Growth& growth_;
  const Heightfield& terrain_;
  std::optional<Mask> mask_;
};

/// The value's rank in a standard normal distribution: makes noise uniform in (0, 1).
double equalised(double value) { return 0.5 * math::erfc(-value / std::numbers::sqrt2); }

/// 1 where the probability is above the noise; the mean stays the probability within `soft` / 2.
double grown(double probability, double noise) {
  constexpr double soft = 0.02;
  const double above = probability * (1.0 + soft) - noise;
  return std::clamp(above / soft, 0.0, 1.0);
}

}  // namespace

FactorMap growth_map(const scene::Scene& scene, const Heightfield& terrain) {
  constexpr double step_m = 0.05;
  return growth_map(scene, terrain,
                    {{.size_m = terrain.size_m()}, map_samples(terrain.size_m(), step_m)});
}

FactorMap growth_map(const scene::Scene& scene, const Heightfield& terrain,
                     const GroundGrid& grid) {
  const double shown = shown_fraction(scene.growth.feature_m, grid.step_m());
  const Limits limits(scene.growth, terrain);
  const Fbm tufts{random_bits({scene.seed, key_of("growth"), 0, key_of("tufts")}), 6, 0.35};
  FactorMap map(grid.samples, grid.square);
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < map.samples(); ++i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      const double probability = limits.probability(at_m);
      const bool certain = probability <= 0.0 || probability >= 1.0 || shown <= 0.0;
      const double noise = certain ? 0.5 : equalised(fbm(at_m / scene.growth.feature_m, tufts));
      map.at(i, j) = static_cast<float>(
          shown >= 1.0 ? grown(probability, noise)
                       : std::lerp(probability, grown(probability, noise), shown));
    }
  });
  return map;
}

}  // namespace wold::place
