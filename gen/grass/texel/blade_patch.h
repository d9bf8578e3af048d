#pragma once

#include <vector>

#include "grass/mechanics/meadow_model.h"

namespace wold::grass {

/// The blades of a patch at one moment, as they are: what the texel stands for.
struct BladePatch {
  double patch_m = 0.0;  ///< side; the patch tiles
  std::vector<Blade> blades;
  std::vector<BladePose> poses;
  std::vector<double> ages;  ///< own weathering degree of each blade
};

/// A variant of the scene's patch, all its samples: scattered once, then withered to any degree.
/// `model` has to outlive it. Throws what ageing_rates() throws.
class WitheringPatch {
 public:
  WitheringPatch(const scene::MeadowPart& meadow, const MeadowModel& model, int variant);

  /// The patch at a weathering degree of the meadow, in [0, 1], under the fraction `snow` in [0, 1]
  /// of what its blades can carry.
  BladePatch at(double weathering, double snow = 0.0) const;

 private:
  const MeadowModel& model_;
  double patch_m_;
  std::vector<Curve> rates_;
  std::vector<std::vector<Blade>> samples_;
  std::vector<std::vector<BladeHistory>>
      histories_;  ///< of each sample; empty: a closed form moves its blades
};

/// What is seen of a place of a blade.
struct SeenPlace {
  glm::vec3 albedo;
  glm::vec3 transmittance;  ///< what of it leaves on the other side
  float specular;
};

/// Leaf and the snow on it at `along` (0 root to 1 tip), where the axis is `at`: a mean by area. A
/// ridge hides half of the blade that it covers.
SeenPlace seen_place(const BladePatch& patch, const MeadowModel& model, std::size_t blade,
                     double along, const AxisPoint& at);

/// Mean albedo of all blades and the snow on them, by the blades' area.
glm::vec3 mean_albedo(const BladePatch& patch, const MeadowModel& model);

}  // namespace wold::grass
