#include "grass/blade_patch.h"

#include "grass/samples.h"

namespace wold::grass {

BladePatch withered_patch(const scene::Scene& scene, const AgeingModel& model, int variant,
                          double weathering) {
  BladePatch patch;
  patch.patch_m = scene.grass.patch_m;
  const std::vector<Curve> rates = ageing_rates(scene.grass);
  for (std::size_t sample = 0; sample < rates.size(); ++sample)
    for (const Blade& blade :
         scatter_blades(scene.grass, scene.ageing, scene.seed, variant, static_cast<int>(sample))) {
      patch.blades.push_back(blade);
      patch.ages.push_back(AgeingModel::blade_age(blade, rates[sample](weathering)));
      patch.poses.push_back(model.pose(blade, patch.ages.back()));
    }
  return patch;
}

}  // namespace wold::grass
