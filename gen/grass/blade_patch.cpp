#include "grass/blade_patch.h"

#include "grass/samples.h"

namespace wold::grass {

WitheringPatch::WitheringPatch(const scene::Scene& scene, const AgeingModel& model, int variant)
    : model_(model), patch_m_(scene.grass.patch_m), rates_(ageing_rates(scene.grass)) {
  for (int sample = 0; sample < sample_count(scene.grass); ++sample)
    samples_.push_back(scatter_blades(scene.grass, scene.ageing, scene.seed, variant, sample));
}

BladePatch WitheringPatch::at(double weathering) const {
  BladePatch patch;
  patch.patch_m = patch_m_;
  for (std::size_t sample = 0; sample < samples_.size(); ++sample)
    for (const Blade& blade : samples_[sample]) {
      patch.blades.push_back(blade);
      patch.ages.push_back(AgeingModel::blade_age(blade, rates_[sample](weathering)));
      patch.poses.push_back(model_.pose(blade, patch.ages.back()));
    }
  return patch;
}

glm::vec3 mean_albedo(const BladePatch& patch, const AgeingModel& model) {
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (std::size_t i = 0; i < patch.blades.size(); ++i) {
    const Blade& blade = patch.blades[i];
    for (const double along : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const double area = (1.0 - along) * double{blade.radius_m * blade.length_m};
      sum += area * glm::dvec3(model.albedo(blade, patch.ages[i], along));
      weights += area;
    }
  }
  return sum / weights;
}

}  // namespace wold::grass
