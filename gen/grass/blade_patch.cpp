#include "grass/blade_patch.h"

namespace wold::grass {

BladePatch withered_patch(const scene::Scene& scene, const AgeingModel& model, int variant,
                          double weathering) {
  BladePatch patch;
  patch.patch_m = scene.grass.patch_m;
  patch.blades = scatter_blades(scene.grass, scene.ageing, scene.seed, variant);
  for (const Blade& blade : patch.blades) {
    patch.ages.push_back(AgeingModel::blade_age(blade, weathering));
    patch.poses.push_back(model.pose(blade, patch.ages.back()));
  }
  return patch;
}

}  // namespace wold::grass
