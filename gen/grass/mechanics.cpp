#include "grass/mechanics.h"

#include <cmath>

namespace wold::grass {
namespace {

// Young's moduli of the fresh tissues (modelling choice within the published ranges: whole blade
// 0.1 to 1 GPa, mesophyll 1 to 10 MPa) and the share of the cross-section that is vein.
constexpr double fresh_vein_pa = 0.5e9;
constexpr double fresh_mesophyll_pa = 5e6;
constexpr double vein_share = 0.1;

/// Linear scale of a body that lost this share of its volume alike in all directions.
double linear_scale(double volume_strain) { return std::cbrt(1.0 - volume_strain); }

}  // namespace

double relieved_loss(double water_lost, double stiffening) {
  return stiffening > 0.0 ? std::log1p(stiffening * water_lost) / stiffening : water_lost;
}

TissueState tissue_state(const scene::Ageing& ageing, double water_lost) {
  const double growth = 1.0 + ageing.stiffening * water_lost;
  const double relieved = relieved_loss(water_lost, ageing.stiffening);
  TissueState tissue;
  tissue.modulus_vein_pa = fresh_vein_pa * growth;
  tissue.modulus_mesophyll_pa = fresh_mesophyll_pa * growth;
  tissue.strain_vein = ageing.vein_shrinkage * relieved;
  tissue.strain_mesophyll = ageing.mesophyll_shrinkage * relieved;
  tissue.stress_vein_pa = tissue.modulus_vein_pa * tissue.strain_vein;
  tissue.stress_mesophyll_pa = tissue.modulus_mesophyll_pa * tissue.strain_mesophyll;
  return tissue;
}

BladePose blade_pose(const Blade& blade, const scene::Ageing& ageing, double water_lost) {
  const TissueState tissue = tissue_state(ageing, water_lost);
  const double vein = vein_share * tissue.modulus_vein_pa;
  const double mesophyll = (1.0 - vein_share) * tissue.modulus_mesophyll_pa;
  const double axial =
      (vein * tissue.strain_vein + mesophyll * tissue.strain_mesophyll) / (vein + mesophyll);
  BladePose pose;
  pose.droop = blade.fresh_droop +
               blade.droop_rate * static_cast<float>(relieved_loss(water_lost, ageing.stiffening));
  pose.length_scale = static_cast<float>(linear_scale(axial));
  pose.vein_width = static_cast<float>(linear_scale(tissue.strain_vein));
  pose.mesophyll_width = static_cast<float>(linear_scale(tissue.strain_mesophyll));
  return pose;
}

}  // namespace wold::grass
