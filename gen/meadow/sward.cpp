#include "meadow/sward.h"

#include <algorithm>
#include <cmath>

#include "core/colour.h"
#include "core/elementary.h"
#include "core/random.h"
#include "place/each_in_view.h"
#include "scene/species.h"
#include "terrain/relief.h"

namespace wold::meadow {
namespace {

constexpr double largest_m = 6.0;
constexpr std::size_t octave_count = 6;

/// Standard deviation of the logarithm of how rough places are.
constexpr double rough_spread = 0.4;
constexpr ScaleFreeNoise::Sizes rough_places{.largest_m = 200.0, .smallest_m = 20.0};

}  // namespace

Sward::Sward(const scene::Scene& scene, double step_m)
    : height_m_(scene::mean_grass(scene).height_m),
      step_m_(step_m),
      rough_places_(random_bits({scene.seed, key_of("growth"), 0, key_of("rough places")}),
                    rough_places, /*hurst=*/0.3, step_m) {
  // The mean square of exp(rough_spread x), x normal, is exp(2 rough_spread^2).
  const double deviation = scene.grass.unevenness * math::exp(-rough_spread * rough_spread) /
                           std::sqrt(static_cast<double>(octave_count));
  double feature_m = largest_m;
  for (std::size_t octave = 0; octave < octave_count; ++octave, feature_m *= 0.5) {
    const std::uint64_t key = random_bits({scene.seed, key_of("growth"), octave, key_of("sward")});
    const glm::dvec2 shift(random_uniform({key, key_of("shift"), 0, 0}),
                           random_uniform({key, key_of("shift"), 1, 0}));
    octaves_.push_back({feature_m, deviation / gradient_noise_deviation, shift, key});
  }
}

Sward::Top Sward::at(const glm::dvec2& at_m, double step_m) const {
  Top top;
  const double rough = math::exp(rough_spread * rough_places_.at(at_m));
  for (const Octave& octave : octaves_) {
    const double shown = shown_fraction(octave.feature_m, std::max(step_m, step_m_));
    if (shown <= 0.0) continue;
    const double height = rough * shown * octave.height;
    const NoiseSlope noise =
        gradient_noise_slope(at_m / octave.feature_m + octave.shift, octave.key);
    top.height += height * noise.value;
    top.ascent += height * height_m_ / octave.feature_m * noise.gradient;
  }
  return top;
}

double Sward::light(const Top& top, const glm::dvec3& up, const glm::dvec3& to_sun, double by_sun) {
  constexpr double opaque = 0.5, shade = 0.5, least = 0.35, most = 1.7, grazing = 0.15;
  const double ground = glm::dot(up, to_sun);
  const double flank = ground - opaque * glm::dot(top.ascent, glm::dvec2(to_sun));
  const double more_sun =
      (std::max(0.0, flank) - std::max(0.0, ground)) / std::max(grazing, ground);
  return std::clamp((1.0 + by_sun * more_sun) * (1.0 + shade * top.height), least, most);
}

FactorMap sward_light_map(const Sward& sward, const terrain::GroundLight& light,
                          const glm::dvec3& to_sun, const Heightfield& terrain,
                          const place::View& view, const Sward::StepAt& step_at) {
  FactorMap map(light.sun.samples(), light.sun.square(), 1.0F);
  place::each_in_view(map, terrain, view, [&](int i, int j, const glm::dvec3& place_m) {
    const glm::dvec2 at_m(place_m);
    const double sun = luminance(light.sun.at(i, j)), sky = luminance(light.sky.at(i, j));
    const double by_sun = sun > 0.0 ? sun / (sun + sky) : 0.0;
    const Sward::Top top = sward.at(at_m, step_at ? step_at(place_m) : 0.0);
    map.at(i, j) = static_cast<float>(
        Sward::light(top, terrain::normal(terrain, at_m.x, at_m.y), to_sun, by_sun));
  });
  return map;
}

}  // namespace wold::meadow
