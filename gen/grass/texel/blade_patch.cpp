#include "grass/texel/blade_patch.h"

#include <algorithm>
#include <numbers>
#include <optional>

#include "core/parallel.h"
#include "grass/geometry/snow_ridge.h"
#include "grass/texel/samples.h"

namespace wold::grass {

WitheringPatch::WitheringPatch(const scene::MeadowPart& meadow, const MeadowModel& model,
                               int variant)
    : model_(model), patch_m_(meadow.grass.patch_m), rates_(ageing_rates(meadow, variant)) {
  for (int sample = 0; sample < static_cast<int>(rates_.size()); ++sample) {
    const std::vector<Blade>& blades =
        samples_.emplace_back(sample_blades(meadow, variant, sample));
    std::vector<BladeHistory>& histories = histories_.emplace_back();
    if (blades.empty() || !model.of(blades.front()).moves_points()) continue;
    histories.resize(blades.size());
    parallel_for(blades.size(),
                 [&](std::size_t i) { histories[i] = model.of(blades[i]).history(blades[i]); });
  }
}

BladePatch WitheringPatch::at(double weathering, double snow) const {
  BladePatch patch;
  patch.patch_m = patch_m_;
  for (std::size_t sample = 0; sample < samples_.size(); ++sample)
    for (std::size_t i = 0; i < samples_[sample].size(); ++i) {
      const Blade& blade = samples_[sample][i];
      const AgeingModel& model = model_.of(blade);
      const double age = AgeingModel::blade_age(blade, rates_[sample](weathering));
      const std::vector<BladeHistory>& histories = histories_[sample];
      patch.blades.push_back(blade);
      patch.ages.push_back(age);
      patch.poses.push_back(histories.empty() ? model.pose(blade, age, snow)
                                              : model.pose(blade, histories[i].at(age), age, snow));
    }
  return patch;
}

SeenPlace seen_place(const BladePatch& patch, const MeadowModel& meadow, std::size_t i,
                     double along, const AxisPoint& at) {
  const Blade& blade = patch.blades[i];
  const AgeingModel& model = meadow.of(blade);
  const BladePose& pose = patch.poses[i];
  const LeafShade shade = model.shade(blade, patch.ages[i], along);
  const SeenPlace leaf{shade.albedo, shade.transmittance, model.specular(blade, patch.ages[i])};
  const SnowRidge ridge = snow_ridge(blade, pose, static_cast<float>(along), at);
  if (ridge.half_height_m <= 0.0F) return leaf;
  const float radius_m = blade.radius_m * pose.mesophyll_width * (1.0F - static_cast<float>(along));
  const float covered = std::min(ridge.half_width_m / radius_m, 1.0F);
  const float leaf_m = std::numbers::pi_v<float> / 2.0F * radius_m * (1.0F - 0.5F * covered);
  const float snow = ridge.area_m() / (ridge.area_m() + leaf_m);
  return {glm::mix(leaf.albedo, snow_albedo, snow), leaf.transmittance * (1.0F - snow),
          leaf.specular * (1.0F - snow)};
}

glm::vec3 mean_albedo(const BladePatch& patch, const MeadowModel& model) {
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (std::size_t i = 0; i < patch.blades.size(); ++i) {
    const Blade& blade = patch.blades[i];
    const float length_m = blade.length_m * patch.poses[i].length_scale;
    std::optional<BladeAxis> axis;  // only snow asks for it
    if (patch.poses[i].snow > 0.0F) axis.emplace(blade, patch.poses[i]);
    for (const double along : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      // Leaves shrink alike; petals shrivel.
      const float width = sits_on_stalk(blade) ? patch.poses[i].mesophyll_width : 1.0F;
      const double area = (1.0 - along) * double{blade.radius_m * blade.length_m * width};
      const AxisPoint at =
          axis ? axis->at(length_m * static_cast<float>(along)) : AxisPoint{{0, 0}, {0, 1}};
      sum += area * glm::dvec3(seen_place(patch, model, i, along, at).albedo);
      weights += area;
    }
  }
  return sum / weights;
}

}  // namespace wold::grass
