#include "place/growth.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "core/normal_distribution.h"
#include "core/parallel.h"
#include "core/random.h"
#include "place/cell_window.h"
#include "place/habitat.h"
#include "place/topography.h"

namespace wold::place {
namespace {

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
        tufts_(Fbm(random_bits({scene.seed, key_of("growth"), 0, key_of("tufts")}), 6, 0.35),
               feature_m_) {}

  double grown_at(const glm::dvec2& at_m, double probability) const {
    if (probability <= 0.0 || probability >= 1.0 || shown_ <= 0.0) return probability;
    const double growth = grown(probability, tufts_.at(at_m));
    return shown_ >= 1.0 ? growth : std::lerp(probability, growth, shown_);
  }

 private:
  double feature_m_, shown_;
  Tufts tufts_;
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
    return normal_cdf((normal_quantile(probability) - field) / softness_);
  }

 private:
  static constexpr double smallest = 0.03, min_softness = 0.01, by_exposure = 0.5;

  ScaleFreeNoise field_;
  double softness_;
};

/// Slopes of a large terrain that face the noon sun of the equinox dry out and are left bare in
/// part. Where users say what grows, they know that, too.
class SunnySlopes {
 public:
  explicit SunnySlopes(const scene::Scene& scene)
      : bare_(is_large(scene) && scene.growth.mask.empty() && scene.terrain.cover.empty() &&
                      scene.terrain.photo.empty()
                  ? most_bare
                  : 0.0),
        sun_(equinox_sun(scene.sun.latitude_deg)) {}

  /// Share of what grows on level ground.
  double grown(const glm::dvec3& up) const {
    constexpr double level = 1.0, sunniest = 1.45;  // sunlight over that of level ground
    if (bare_ <= 0.0) return 1.0;
    return 1.0 -
           bare_ * glm::smoothstep(level, sunniest, sun_over_level(-glm::dvec2(up) / up.z, sun_));
  }

 private:
  static constexpr double most_bare = 0.4;  // a modelling choice

  double bare_;
  glm::dvec3 sun_;
};

/// Of value (i, j) of a map on the surface's grid.
double limited(const GrowthLimits& limits, const terrain::Surface& surface, int i, int j) {
  const double on_level = limits.on_level(surface.place_m(i, j), surface.height_m(i, j));
  return limits.ask_for_slope() ? on_level * limits.on_slope(surface.slope_deg(i, j)) : on_level;
}

template <class GrownAt>
FactorMap filled(const scene::Scene& scene, const terrain::Surface& surface,
                 const GrownAt& grown_at) {
  const GrowthLimits limits(scene, scene.growth);
  const Habitats habitats(scene, surface.heights_m());
  const SunnySlopes sunny(scene);
  FactorMap map(surface.grid().samples, surface.grid().square);
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(surface.part(j), [&](int i) {
      const double probability = limited(limits, surface, i, j) *
                                 habitats.any(surface.place_m(i, j)) * surface.cover(i, j).grass *
                                 (1.0 - surface.scree(i, j)) * (1.0 - surface.boulder(i, j).cover) *
                                 sunny.grown(surface.up(i, j));
      map.at(i, j) = static_cast<float>(grown_at(i, j, probability) * (1.0 - surface.water(i, j)) *
                                        (1.0 - surface.worn(i, j)));
    });
  });
  return map;
}

}  // namespace

FactorMap growth_map(const scene::Scene& scene, const Heightfield& terrain,
                     const terrain::KnownGround& known) {
  constexpr double step_m = 0.05;
  return growth_map(
      scene, terrain::Surface(terrain, nullptr,
                              {{.size_m = terrain.size_m()}, map_samples(terrain.size_m(), step_m)},
                              known));
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
