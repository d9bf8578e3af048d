#include "meadow/mean_beam.h"

#include <vector>

#include "grass/ageing/ageing_curves.h"
#include "grass/geometry/blade.h"
#include "grass/mechanics/mechanics.h"
#include "scene/species.h"

namespace wold::meadow {
namespace {

wind::Beam beam_of(const scene::Species& species, double weathering, double snow) {
  const grass::Blade blade = grass::mean_blade(species.plant, species.physiology);
  const double lost =
      1.0 - grass::load_curve(grass::CurveKind::water, species.physiology.water)(weathering);
  const double weight = grass::relative_weight(lost);
  return {
      double{blade.length_m}, 2.0 * double{blade.radius_m},
      grass::fresh_mass_kg_m(blade) * (weight + grass::relative_snow_weight() * snow),
      grass::fresh_stiffness_n_m2(blade) * weight / grass::relative_load(species.physiology, lost)};
}

/// Stalks of flowers are few amid the grass, and stiff, and shrubs stand still: leaves of grass
/// count, where there are any.
std::vector<scene::Species> waving_species(const scene::Scene& scene) {
  const std::vector<scene::Species> all = scene::species_of(scene);
  std::vector<scene::Species> leaves = all;
  std::erase_if(leaves, [](const scene::Species& one) {
    return scene::flowers(one) || scene::is_shrub(one);
  });
  return leaves.empty() ? all : leaves;
}

}  // namespace

wind::Beam mean_beam(const scene::Scene& scene, double weathering, double snow) {
  wind::Beam mean;
  double shares = 0.0;
  for (const scene::Species& species : waving_species(scene)) {
    const wind::Beam beam = beam_of(species, weathering, snow);
    mean.length_m += species.share * beam.length_m;
    mean.width_m += species.share * beam.width_m;
    mean.mass_kg_m += species.share * beam.mass_kg_m;
    mean.stiffness_n_m2 += species.share * beam.stiffness_n_m2;
    shares += species.share;
  }
  return {mean.length_m / shares, mean.width_m / shares, mean.mass_kg_m / shares,
          mean.stiffness_n_m2 / shares};
}

}  // namespace wold::meadow
