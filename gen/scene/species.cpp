#include "scene/species.h"

#include <algorithm>
#include <cmath>

namespace wold::scene {
namespace {

/// Standard deviations at which lengths of blades are cut.
constexpr double max_deviations = 2.2;

double sum_of_shares(const std::vector<Species>& species) {
  double sum = 0.0;
  for (const Species& one : species) sum += one.share;
  return sum;
}

}  // namespace

std::vector<Species> species_of(const MeadowPart& meadow) {
  if (!meadow.species.empty()) return meadow.species;
  return {{.plant = meadow.grass, .physiology = meadow.ageing}};
}

std::vector<int> blades_of(const MeadowPart& meadow) {
  const std::vector<Species> species = species_of(meadow);
  const double sum = sum_of_shares(species);
  std::vector<int> counts;
  double share = 0.0;
  int before = 0;
  for (const Species& one : species) {
    share += one.share;
    const int until = static_cast<int>(std::lround(meadow.grass.blades * (share / sum)));
    counts.push_back(until - before);
    before = until;
  }
  return counts;
}

bool is_hair(const Physiology& physiology) { return physiology.fur.clumps > 0; }

bool has_hair(const Scene& scene) {
  if (scene.species.empty()) return is_hair(scene.ageing);
  return std::ranges::any_of(scene.species,
                             [](const Species& one) { return is_hair(one.physiology); });
}

Grass mean_grass(const MeadowPart& meadow) {
  Grass grass = meadow.grass;
  const std::vector<Species> species = species_of(meadow);
  const double sum = sum_of_shares(species);
  grass.height_m = grass.width_m = 0.0;
  for (const Species& one : species) {
    grass.height_m += one.share / sum * one.plant.height_m;
    grass.width_m += one.share / sum * one.plant.width_m;
  }
  return grass;
}

double longest_blade_m(const Plant& plant) {
  return plant.height_m * (1.0 + max_deviations * plant.height_spread);
}

double blade_area_m2(const MeadowPart& meadow) {
  const std::vector<Species> species = species_of(meadow);
  const std::vector<int> blades = blades_of(meadow);
  double area_m2 = 0.0;
  for (std::size_t i = 0; i < species.size(); ++i)
    area_m2 += blades[i] * (0.5 * species[i].plant.height_m * species[i].plant.width_m);
  return area_m2;
}

}  // namespace wold::scene
