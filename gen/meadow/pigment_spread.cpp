#include "meadow/pigment_spread.h"

#include <algorithm>
#include <cmath>

#include "core/between.h"
#include "core/elementary.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "core/random.h"
#include "grass/mechanics/meadow_model.h"
#include "grass/texel/fibres.h"
#include "meadow/lean_light.h"
#include "place/cell_window.h"
#include "place/each_in_view.h"
#include "scene/species.h"

namespace wold::meadow {
namespace {

constexpr double max_richness = 2.5;
constexpr std::size_t degrees = 33;

/// The meadow's species where the ground has that richness.
std::vector<scene::Species> enriched(const scene::Scene& scene, double richness) {
  const double factor = math::exp(scene.ageing.pigment_spread * richness);
  std::vector<scene::Species> species = scene::species_of(scene);
  for (scene::Species& one : species) {
    one.physiology.chlorophyll_ug_cm2 *= factor;
    one.physiology.brown_pigment /= factor;
  }
  return species;
}

/// Large terrains have rich and poor places of all sizes.
double largest_feature_m(const scene::Scene& scene) {
  constexpr double of_terrain = 0.1;
  const double feature_m = scene.ageing.pigment_spread_feature_m;
  return place::is_large(scene) ? std::max(feature_m, of_terrain * scene.terrain.size_m)
                                : feature_m;
}

std::vector<Fbm> octaves_of(const scene::Scene& scene, double largest_m) {
  const int larger =
      static_cast<int>(math::log2(largest_m / scene.ageing.pigment_spread_feature_m));
  const auto count = static_cast<std::uint64_t>(4 + std::max(0, larger));
  const std::uint64_t key = random_bits({scene.seed, key_of("variety"), 0, key_of("field")});
  std::vector<Fbm> octaves;
  for (std::uint64_t octave = 0; octave < count; ++octave)
    octaves.emplace_back(random_bits({key, key_of("octave"), octave, 0}), /*octaves=*/1);
  return octaves;
}

}  // namespace

PigmentSpread::PigmentSpread(const scene::Scene& scene, const grass::WitheringPatch& patch,
                             double snow, const grass::Lighting& lighting)
    : largest_m_(largest_feature_m(scene)),
      rough_(place::is_large(scene) ? 0.9 : 0.7),
      octaves_(octaves_of(scene, largest_m_)),
      factors_(degrees) {
  std::vector<grass::MeadowModel> models;
  const std::size_t count = ByRichness{}.size();
  for (std::size_t k = 0; k < count; ++k)
    models.emplace_back(
        enriched(scene, max_richness * (2.0 * static_cast<double>(k) / (count - 1.0) - 1.0)));
  parallel_for(degrees, [&](std::size_t degree) {
    const grass::BladePatch withered = patch.at(static_cast<double>(degree) / (degrees - 1), snow);
    ByRichness& factors = factors_[degree];
    std::ranges::transform(models, factors.begin(), [&](const grass::MeadowModel& model) {
      constexpr int fibres = 150;
      const LeanLight light(grass::representative_fibres(withered, model, fibres), lighting,
                            static_cast<float>(scene.grass.specular_exponent));
      return glm::max(light.upright(), 1e-6F);  // a channel may be empty
    });
    const glm::vec3 usual = factors[count / 2];
    for (glm::vec3& factor : factors) factor /= usual;
  });
}

double PigmentSpread::richness(const glm::dvec2& at_m, double step_m) const {
  double sum = 0.0, variance = 0.0, height = 1.0, feature_m = largest_m_;
  for (const Fbm& octave : octaves_) {
    const double shown = shown_fraction(feature_m, step_m);
    if (shown > 0.0) sum += shown * height * octave.at(at_m / feature_m);
    variance += height * height;
    height *= rough_;
    feature_m *= 0.5;
  }
  return std::clamp(sum / std::sqrt(variance), -max_richness, max_richness);
}

glm::vec3 PigmentSpread::factor(double richness, double weathering) const {
  const Between degree(weathering, factors_.size());
  const Between rich(0.5 + 0.5 * richness / max_richness, ByRichness{}.size());
  const auto at_degree = [&](std::size_t k) {
    return glm::mix(factors_[k][rich.first], factors_[k][rich.first + 1], rich.part);
  };
  return glm::mix(at_degree(degree.first), at_degree(degree.first + 1), degree.part);
}

ColourMap pigment_spread_map(const PigmentSpread& pigment_spread, const place::Withering& withering,
                             int frame, const Heightfield& terrain, const place::View& view,
                             const GroundGrid& grid) {
  ColourMap map(grid.samples, grid.square, glm::vec3(1.0F));
  place::each_in_view(map, terrain, view, [&](int i, int j, const glm::dvec3& place_m) {
    const glm::dvec2 at_m(place_m);
    map.at(i, j) = pigment_spread.factor(pigment_spread.richness(at_m, grid.step_m()),
                                         withering.at(at_m, frame));
  });
  return map;
}

}  // namespace wold::meadow
