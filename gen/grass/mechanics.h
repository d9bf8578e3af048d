#pragma once

#include "grass/blade.h"
#include "scene/scene.h"

namespace wold::grass {

/// Strains and stresses of the two tissues of a drying blade (paper 1 section 3.1). Strains are
/// shares of the volume lost, positive for shrinkage; stresses and moduli in pascals.
struct TissueState {
  double modulus_vein_pa = 0.0;
  double modulus_mesophyll_pa = 0.0;
  double strain_vein = 0.0;
  double strain_mesophyll = 0.0;
  double stress_vein_pa = 0.0;
  double stress_mesophyll_pa = 0.0;
};

/// Deformation that has built up after `water_lost` (0 fresh to 1 dry) when every further bit of
/// lost water deforms by the inverse of a stiffness that grows as E(x) = E0 (1 + b x):
///   S(x) = integral_0^x dx' / (1 + b x') = ln(1 + b x) / b.
/// It slows down and comes to rest, as the paper asks of shrinkage; b = 0 gives S = x.
double relieved_loss(double water_lost, double stiffening);

/// The tissues after `water_lost`. Initial strains are k dw (paper: eps0 = dV / V0 = k dw), slowed
/// by relieved_loss; sigma = E eps. The paper prints Ev < Em but argues that veins resist more;
/// here Ev > Em: 0.5 GPa along the fibres, 5 MPa in the mesophyll (Vincent 1982: fibres carry
/// 90-95 % of the longitudinal stiffness).
TissueState tissue_state(const scene::Ageing& ageing, double water_lost);

/// Shape of a blade after `water_lost`: lengths follow the stiff veins and the mesophyll bonded to
/// them, by their stiffness; widths follow each tissue's own strain; droop grows as support is
/// lost.
BladePose blade_pose(const Blade& blade, const scene::Ageing& ageing, double water_lost);

}  // namespace wold::grass
