#include "grass/geometry/meadow_samples.h"

#include <algorithm>

#include "scene/species.h"

namespace wold::grass {

std::vector<MeadowSample> samples_of(const scene::MeadowPart& meadow, int variant) {
  const std::vector<scene::Species> species = scene::species_of(meadow);
  const scene::Mixture mixture = scene::mixture_of(meadow, variant);
  const std::vector<int> blades = scene::blades_of(meadow, mixture);
  std::vector<MeadowSample> samples;
  for (std::size_t i = 0; i < mixture.size(); ++i) {
    const std::vector<scene::CurveChoice>& rates =
        species[static_cast<std::size_t>(mixture[i])].plant.mingle;
    const int count = std::max(1, static_cast<int>(rates.size()));
    for (int k = 0; k < count; ++k) {
      MeadowSample sample{mixture[i], blades[i] / count + (k < blades[i] % count ? 1 : 0), {}};
      if (!rates.empty()) sample.rate = rates[static_cast<std::size_t>(k)];
      samples.push_back(std::move(sample));
    }
  }
  return samples;
}

}  // namespace wold::grass
