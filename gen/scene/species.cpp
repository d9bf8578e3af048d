#include "scene/species.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wold::scene {
namespace {

/// Standard deviations at which lengths of blades are cut.
constexpr double max_deviations = 2.2;

/// `blades` in proportion to the shares, each rounded so that the sum is exact, and one at least
/// where there are enough.
std::vector<int> shared_out(int blades, const std::vector<double>& shares) {
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  std::vector<int> counts;
  double share = 0.0;
  int before = 0;
  for (const double one : shares) {
    share += one;
    const int until = static_cast<int>(std::lround(blades * (share / sum)));
    counts.push_back(until - before);
    before = until;
  }
  for (int& count : counts) {
    int& most = *std::ranges::max_element(counts);
    if (count > 0 || most < 2) continue;
    ++count;
    --most;
  }
  return counts;
}

/// Of the terrain, as far as a habitat alone says it: ranks of wetness are shares of it.
double cover_of(const Habitat& habitat) {
  return habitat.cover * (habitat.wettest - habitat.driest);
}

/// Which part of the ground each species is the top of, sum 1: shrubs of what they cover, the rest
/// by their shares, as shrubs do where nothing else grows.
std::vector<double> ground_fractions(const std::vector<Species>& species) {
  double covered = 0.0, rooted = 0.0, all = 0.0;
  for (const Species& one : species) {
    (is_shrub(one) ? covered : rooted) += is_shrub(one) ? cover_of(one.habitat) : one.share;
    all += one.share;
  }
  std::vector<double> fractions;
  for (const Species& one : species) {
    if (rooted <= 0.0)
      fractions.push_back(one.share / all);
    else if (is_shrub(one))
      fractions.push_back(cover_of(one.habitat) / std::max(1.0, covered));
    else
      fractions.push_back(std::max(0.0, 1.0 - covered) * one.share / rooted);
  }
  return fractions;
}

Mixture all_species(const MeadowPart& meadow) {
  Mixture all(species_of(meadow).size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Of the mixture's plants of which `counts` holds.
template <class Counts>
double blade_area_m2(const MeadowPart& meadow, const Mixture& mixture, const Counts& counts) {
  const std::vector<Species> species = species_of(meadow);
  const std::vector<int> blades = blades_of(meadow, mixture);
  double area_m2 = 0.0;
  for (std::size_t k = 0; k < mixture.size(); ++k) {
    const Species& one = species[static_cast<std::size_t>(mixture[k])];
    if (counts(one.plant)) area_m2 += blades[k] * blade_area_m2(one);
  }
  return area_m2;
}

double blade_area_m2(const MeadowPart& meadow, const Mixture& mixture) {
  return blade_area_m2(meadow, mixture, [](const Plant&) { return true; });
}

}  // namespace

std::vector<Species> species_of(const MeadowPart& meadow) {
  if (!meadow.species.empty()) return meadow.species;
  return {{.plant = meadow.grass, .physiology = meadow.ageing}};
}

bool has_habitat(const Species& species) {
  Habitat everywhere;
  everywhere.feature_m = species.habitat.feature_m;
  return species.habitat != everywhere;
}

std::vector<Mixture> mixtures_of(const MeadowPart& meadow) {
  const std::vector<Species> species = species_of(meadow);
  const auto placed = static_cast<unsigned>(std::ranges::count_if(species, has_habitat));
  std::vector<Mixture> mixtures;
  for (unsigned missing = 0; missing < 1U << placed; ++missing) {
    Mixture mixture;
    unsigned bit = 1;
    for (std::size_t i = 0; i < species.size(); ++i) {
      const bool grows = !has_habitat(species[i]) || (missing & bit) == 0;
      if (grows) mixture.push_back(static_cast<int>(i));
      if (has_habitat(species[i])) bit <<= 1;
    }
    if (!mixture.empty()) mixtures.push_back(std::move(mixture));
  }
  return mixtures;
}

int patch_count(const MeadowPart& meadow) {
  return static_cast<int>(mixtures_of(meadow).size()) * meadow.grass.variants;
}

int mixture_number(const MeadowPart& meadow, int patch) { return patch / meadow.grass.variants; }

int patch_number(const MeadowPart& meadow, int mixture, int variant) {
  return mixture * meadow.grass.variants + variant;
}

Mixture mixture_of(const MeadowPart& meadow, int patch) {
  return mixtures_of(meadow).at(static_cast<std::size_t>(mixture_number(meadow, patch)));
}

bool has_placed_shrubs(const MeadowPart& meadow, int mixture) {
  const std::vector<Species> species = species_of(meadow);
  return std::ranges::any_of(mixtures_of(meadow).at(static_cast<std::size_t>(mixture)),
                             [&](int number) {
                               const Species& one = species[static_cast<std::size_t>(number)];
                               return is_shrub(one) && has_habitat(one);
                             });
}

int without_shrubs(const MeadowPart& meadow, int mixture) {
  auto missing = static_cast<unsigned>(mixture);
  unsigned bit = 1;
  for (const Species& one : species_of(meadow)) {
    if (!has_habitat(one)) continue;
    if (is_shrub(one)) missing |= bit;
    bit <<= 1;
  }
  const auto without = static_cast<int>(missing);
  return without < static_cast<int>(mixtures_of(meadow).size()) ? without : mixture;
}

std::vector<int> blades_of(const MeadowPart& meadow) {
  return blades_of(meadow, all_species(meadow));
}

std::vector<int> blades_of(const MeadowPart& meadow, const Mixture& mixture) {
  const std::vector<Species> species = species_of(meadow);
  const auto species_at = [&](int one) { return species.at(static_cast<std::size_t>(one)); };
  std::vector<double> shares;
  for (const int one : mixture)
    if (!is_shrub(species_at(one))) shares.push_back(species_at(one).share);
  const std::vector<int> rooted = shared_out(meadow.grass.blades, shares);
  std::vector<int> counts;
  auto next = rooted.begin();
  for (const int one : mixture) {
    const double on_twigs = species_at(one).share * meadow.grass.blades;
    counts.push_back(
        is_shrub(species_at(one)) ? std::max(1, static_cast<int>(std::lround(on_twigs))) : *next++);
  }
  return counts;
}

bool is_shrub(const Species& species) { return species.plant.crown_m > 0.0; }

bool flowers(const Species& species) { return species.flower.petals > 0; }

long drawn_of(const MeadowPart& meadow, int patch) {
  const std::vector<Species> species = species_of(meadow);
  const Mixture mixture = mixture_of(meadow, patch);
  const std::vector<int> blades = blades_of(meadow, mixture);
  long drawn = 0;
  for (std::size_t k = 0; k < mixture.size(); ++k) {
    const Species& one = species[static_cast<std::size_t>(mixture[k])];
    const int each = flowers(one) ? 1 + one.flower.petals + (one.flower.disc_m > 0.0 ? 1 : 0) : 1;
    drawn += static_cast<long>(blades[k]) * each;
  }
  return drawn;
}

long max_drawn(const MeadowPart& meadow) {
  long most = 0;
  for (int patch = 0; patch < patch_count(meadow); patch += meadow.grass.variants)
    most = std::max(most, drawn_of(meadow, patch));
  return most;
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
  const std::vector<double> weights = ground_fractions(species);
  grass.height_m = grass.width_m = grass.crown_m = 0.0;
  for (std::size_t i = 0; i < species.size(); ++i) {
    grass.height_m += weights[i] * standing_m(species[i].plant);
    grass.width_m += weights[i] * species[i].plant.width_m;
  }
  return grass;
}

double standing_m(const Plant& plant) { return plant.crown_m + plant.height_m; }

double max_standing_m(const Plant& plant) {
  return plant.crown_m + plant.height_m * (1.0 + max_deviations * plant.height_spread);
}

double rooted_fraction(const MeadowPart& meadow, const Mixture& mixture) {
  const double rooted_m2 =
      blade_area_m2(meadow, mixture, [](const Plant& plant) { return plant.crown_m <= 0.0; });
  return rooted_m2 / blade_area_m2(meadow, mixture);
}

double blade_area_m2(const Species& species) {
  const Flower& flower = species.flower;
  return 0.5 * (species.plant.height_m * species.plant.width_m +
                flower.petals * flower.length_m * flower.width_m);
}

double blade_area_m2(const MeadowPart& meadow) {
  return blade_area_m2(meadow, all_species(meadow));
}

double max_blade_area_m2(const MeadowPart& meadow) {
  double max_m2 = 0.0;
  for (const Mixture& mixture : mixtures_of(meadow))
    max_m2 = std::max(max_m2, blade_area_m2(meadow, mixture));
  return max_m2;
}

}  // namespace wold::scene
