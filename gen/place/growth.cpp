#include "place/growth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "cloud/ranks.h"
#include "core/elementary.h"
#include "core/image.h"
#include "core/interpolation.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "core/random.h"
#include "place/cell_window.h"

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
  Limits(const scene::Scene& scene, const terrain::Surface& surface)
      : growth_(scene.growth), surface_(surface) {
    if (is_large(scene)) {
      constexpr double large_strip_deg = 24.0, large_strip = 0.015;
      slope_strip_deg_ = large_strip_deg;
      height_strip_m_ = std::max(height_strip_m_, large_strip * scene.terrain.size_m);
    }
    if (!growth_.mask.empty()) mask_.emplace(growth_.mask, scene.terrain.size_m);
  }

  /// Of value (i, j) of a map on the surface's grid.
  double probability(int i, int j) const {
    const double height_m = surface_.height_m(i, j);
    double p = growth_.cover;
    if (growth_.steepest_deg < 90.0)
      p *= below(surface_.slope_deg(i, j), growth_.steepest_deg, slope_strip_deg_);
    p *= below(height_m, growth_.highest_m, height_strip_m_);
    p *= below(-height_m, -growth_.lowest_m, height_strip_m_);
    return mask_ ? p * mask_->at(surface_.place_m(i, j)) : p;
  }

 private:
  const scene::Growth& growth_;
  const terrain::Surface& surface_;
  double slope_strip_deg_ = 8.0;  ///< in which growth ends; it ends slowly on large terrains
  double height_strip_m_ = growth_.feature_m;
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

/// Bare patches of one size.
class Patches {
 public:
  Patches(const scene::Scene& scene, double step_m)
      : feature_m_(scene.growth.feature_m),
        shown_(shown_fraction(feature_m_, step_m)),
        tufts_{random_bits({scene.seed, key_of("growth"), 0, key_of("tufts")}), 6, 0.35} {}

  double grown_at(const glm::dvec2& at_m, double probability) const {
    if (probability <= 0.0 || probability >= 1.0 || shown_ <= 0.0) return probability;
    const double growth = grown(probability, equalised(fbm(at_m / feature_m_, tufts_)));
    return shown_ >= 1.0 ? growth : std::lerp(probability, growth, shown_);
  }

 private:
  double feature_m_, shown_;
  Fbm tufts_;
};

/// Bare patches of all sizes, from a tenth of a large terrain down, and more of them where the
/// ground stands out than where soil and water gather. What is finer than the map's step shows as
/// the share of it that is grown.
class ScaleFreePatches {
 public:
  ScaleFreePatches(const scene::Scene& scene, double step_m)
      : field_(random_bits({scene.seed, key_of("growth"), 0, key_of("tufts")}),
               {std::max(scene.growth.feature_m, 0.1 * scene.terrain.size_m),
                smallest * scene.growth.feature_m},
               /*hurst=*/0.1, step_m),
        softness_(std::sqrt(std::max(1.0 - field_.shown(), min_softness))) {}

  double grown_at(const glm::dvec2& at_m, double probability, double exposure) const {
    if (probability <= 0.0 || probability >= 1.0) return probability;
    const double of_exposure = std::clamp(exposure, -2.0, 2.0);
    const double field =
        std::sqrt(1.0 - by_exposure * by_exposure) * field_.at(at_m) + by_exposure * of_exposure;
    return cloud::rank_of_gaussian((cloud::gaussian_of_rank(probability) - field) / softness_);
  }

 private:
  static constexpr double smallest = 0.03, min_softness = 0.01, by_exposure = 0.5;

  ScaleFreeNoise field_;
  double softness_;
};

template <class GrownAt>
FactorMap filled(const scene::Scene& scene, const terrain::Surface& surface,
                 const GrownAt& grown_at) {
  const Limits limits(scene, surface);
  FactorMap map(surface.grid().samples, surface.grid().square);
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < map.samples(); ++i)
      map.at(i, j) = static_cast<float>(grown_at(i, j, limits.probability(i, j)));
  });
  return map;
}

}  // namespace

FactorMap growth_map(const scene::Scene& scene, const Heightfield& terrain) {
  constexpr double step_m = 0.05;
  return growth_map(scene, terrain::Surface(terrain, nullptr,
                                            {{.size_m = terrain.size_m()},
                                             map_samples(terrain.size_m(), step_m)}));
}

FactorMap growth_map(const scene::Scene& scene, const terrain::Surface& surface) {
  const double step_m = surface.grid().step_m();
  if (is_large(scene))
    return filled(scene, surface,
                  [&, patches = ScaleFreePatches(scene, step_m)](int i, int j, double probability) {
                    return patches.grown_at(surface.place_m(i, j), probability,
                                            surface.exposure(i, j));
                  });
  return filled(scene, surface,
                [&, patches = Patches(scene, step_m)](int i, int j, double probability) {
                  return patches.grown_at(surface.place_m(i, j), probability);
                });
}

}  // namespace wold::place
