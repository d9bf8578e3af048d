#pragma once

#include "core/curve.h"
#include "grass/geometry/blade.h"
#include "scene/scene.h"

namespace wold::grass {

/// Strains and stresses of the two tissues of a drying blade ([TVT] section 3.1). Strains are
/// fractions of the volume lost, positive for shrinkage; stresses and moduli in pascals.
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
/// It slows down and comes to rest, as [TVT] asks of shrinkage; b = 0 gives S = x.
double relieved_loss(double water_lost, double stiffening);

/// The tissues after `water_lost`. Initial strains are k dw ([TVT]: eps0 = dV / V0 = k dw), slowed
/// by relieved_loss; sigma = E eps. [TVT] prints Ev < Em but argues that veins resist more;
/// here Ev > Em: 0.5 GPa along the fibres, 5 MPa in the mesophyll (Vincent 1982: fibres carry
/// 90-95 % of the longitudinal stiffness).
TissueState tissue_state(const scene::Physiology& ageing, double water_lost);

/// B = q L^3 / (E I) of a fresh blade that bends under its own weight. Of a thin blade of width w,
/// thickness t and density rho, folded to the depth d, q = rho g w t and I = w t d^2 / 12 (a strip
/// that stands at an angle), so that width and thickness cancel:
///   B = 12 rho g L^3 / (E d^2).
/// For a flat blade d is t: 3 mm x 0.2 mm give 0.59 at 5 cm, 4.7 at 10 cm, 38 at 20 cm; a keel of
/// three to five times t makes it stiffer 10 to 30 times.
double fresh_load(const Blade& blade);

/// Mass of a fresh blade per length, kg/m, and E I with which it bears fresh_load().
double fresh_mass_kg_m(const Blade& blade);
double fresh_stiffness_n_m2(const Blade& blade);

/// Weight of a blade after `water_lost`, that of the fresh one being 1; of the snow that one can
/// carry.
double relative_weight(double water_lost);
double relative_snow_weight();

/// Parts of a blade's E I after `water_lost`, that of the fresh one being 1: its cell walls', and
/// what turgor adds to it.
double wall_stiffness(const scene::Physiology& ageing, double water_lost);
double turgor_stiffness(const scene::Physiology& ageing, double water_lost);

/// What comes back of relieved_loss(max_lost), which moves blades by [TVT]'s rule, when
/// `water_lost` <= `max_lost` is all that is lacking again: of what sank while turgor went, the
/// share that turgor bears.
double recovered_loss(const scene::Physiology& ageing, double water_lost, double max_lost);

/// The load after `water_lost` (0 to 1), that of the fresh blade being 1. Weight goes with the
/// water; the walls stiffen as they dry, E(x) = E0 (1 + b x), turgor's fraction of the stiffness is
/// gone at the turgor loss point, and the blade grows thinner by the volume its soft tissue loses
/// (Gardner and Ehlig 1965, Plant Physiology 40:705: leaves shrink in thickness, hardly in area).
/// It rises while the blade wilts and falls as it dries.
double relative_load(const scene::Physiology& ageing, double water_lost);

/// The largest relative_load a blade has borne, from its growth on (1) up to an age. What sank
/// while limp sets as it dries: a fallen blade does not stand up again.
Curve heaviest_load(const scene::Physiology& ageing, const Curve& water);

/// [TVT]'s droop c of a blade on which the fraction `snow` of the snow it can carry lies (0 to
/// 1).
///
/// Loads add up, and a small load turns the tip in proportion: with the droop c from the blade's
/// own weight the snow's turns it by c sqrt(L) times the ratio of the weights. The way to
/// lying is short, so it is approached exponentially: no snow turns a tip beyond a polar angle of
/// 75 degrees, where it points at the ground; a blade that lies lower stays there. Without snow
/// it is `droop` again.
float snowed_droop(const Blade& blade, float droop, double snow);

/// How much of its water a blade lacks, and the most that it has lacked: 0 to 1.
struct WaterLoss {
  /// Of a blade that lacks the most it ever did.
  WaterLoss(double lost) : now(lost), max(lost) {}
  WaterLoss(double lost, double max_lost) : now(lost), max(max_lost) {}
  double now;
  double max;
};

/// Shape of a blade after a loss of water: lengths follow the stiff veins and the mesophyll bonded
/// to them, by their stiffness; widths follow each tissue's own strain; [TVT]'s droop grows as
/// support is lost, and of it only what turgor held comes back with water (recovered_loss()); the
/// elastica's load is `heaviest` times the fresh one. The fraction `snow` of the
/// snow that it can carry (0 to 1) bends it further for as long as it lies. Flowers neither bow nor
/// grow shorter, nor do their stalks: they are stiff, and the one sits on the other.
BladePose blade_pose(const Blade& blade, const scene::Physiology& ageing, const WaterLoss& lost,
                     double heaviest, double snow = 0.0);

}  // namespace wold::grass
