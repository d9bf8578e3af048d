#include "grass/mechanics/mechanics.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/angle.h"
#include "core/elementary.h"
#include "grass/geometry/snow_ridge.h"
#include "grass/mechanics/vein_forces.h"

namespace wold::grass {
namespace {

// Young's moduli of the fresh tissues (modelling choice within the published ranges: whole blade
// 0.1 to 1 GPa, mesophyll 1 to 10 MPa) and the fraction of the cross-section that is vein.
constexpr double fresh_vein_pa = 0.5e9;
constexpr double fresh_mesophyll_pa = 5e6;
constexpr double vein_fraction = 0.1;

/// Of the whole fresh leaf, with the air in it (modelling choice).
constexpr double leaf_kg_m3 = 800.0;
/// Of a fresh leaf (modelling choice, fresh_load()).
constexpr double leaf_thickness_m = 0.0002;
/// What a leaf's snow weighs at most, the fresh leaf being 1: 2.7.
constexpr double snow_per_leaf = leaf_snow_kg_m2 / (leaf_kg_m3 * leaf_thickness_m);
/// Polar angle beyond which snow turns no tip.
constexpr double lowest_tip = radians(75.0);
/// Water in a fresh leaf: 240 % of its dry mass (models/ageing/water_standard.toml).
constexpr double water_mass_fraction = 240.0 / 340.0;
/// Water lost when turgor is gone; grasses lose it near a relative water content of 0.8 (modelling
/// choice).
constexpr double turgor_loss = 0.2;
/// What remains of a blade's thickness without its water at the least: the walls.
constexpr double thinnest = 0.1;

/// Linear scale of a body that lost this fraction of its volume alike in all directions.
double linear_scale(double volume_strain) { return math::cbrt(1.0 - volume_strain); }

/// What remains of turgor, 1 to 0.
double turgor_left(double water_lost) { return std::max(1.0 - water_lost / turgor_loss, 0.0); }

/// Of a blade's second moment of area, cubed thickness.
double relative_section(const scene::Physiology& ageing, double water_lost) {
  const double thickness =
      std::max(1.0 - tissue_state(ageing, water_lost).strain_mesophyll, thinnest);
  return thickness * thickness * thickness;
}

/// E I of a blade after `water_lost`, that of the fresh one being 1.
double relative_stiffness(const scene::Physiology& ageing, double water_lost) {
  const TissueState tissue = tissue_state(ageing, water_lost);
  const double modulus = (1.0 - ageing.turgor_support) * tissue.modulus_vein_pa / fresh_vein_pa +
                         ageing.turgor_support * turgor_left(water_lost);
  return modulus * relative_section(ageing, water_lost);
}

/// Of a straight blade that stays as long as it is.
BladePose stiff_pose(const TissueState& tissue, double snow) {
  BladePose pose;
  pose.snow = static_cast<float>(snow);
  pose.vein_width = static_cast<float>(linear_scale(tissue.strain_vein));
  pose.mesophyll_width = static_cast<float>(linear_scale(tissue.strain_mesophyll));
  return pose;
}

}  // namespace

double relieved_loss(double water_lost, double stiffening) {
  return stiffening > 0.0 ? math::log1p(stiffening * water_lost) / stiffening : water_lost;
}

TissueState tissue_state(const scene::Physiology& ageing, double water_lost) {
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

double fresh_load(const Blade& blade) {
  const double length_m = double{blade.length_m};
  const double depth_m = double{blade.keel_depth_m};
  // The fibres of the veins carry the bending (Vincent 1982).
  return 12.0 * leaf_kg_m3 * gravity_m_s2 * length_m * length_m * length_m /
         (fresh_vein_pa * depth_m * depth_m);
}

double fresh_mass_kg_m(const Blade& blade) {
  return leaf_kg_m3 * leaf_thickness_m * 2.0 * double{blade.radius_m};
}

double fresh_stiffness_n_m2(const Blade& blade) {
  const double length_m = double{blade.length_m};
  return fresh_mass_kg_m(blade) * gravity_m_s2 * length_m * length_m * length_m / fresh_load(blade);
}

double relative_weight(double water_lost) { return 1.0 - water_mass_fraction * water_lost; }

double relative_snow_weight() { return snow_per_leaf; }

double wall_stiffness(const scene::Physiology& ageing, double water_lost) {
  return (1.0 - ageing.turgor_support) * (1.0 + ageing.stiffening * water_lost) *
         relative_section(ageing, water_lost);
}

double turgor_stiffness(const scene::Physiology& ageing, double water_lost) {
  return ageing.turgor_support * turgor_left(water_lost) * relative_section(ageing, water_lost);
}

double recovered_loss(const scene::Physiology& ageing, double water_lost, double max_lost) {
  const auto sunk = [&](double lost) {
    return relieved_loss(std::min(lost, turgor_loss), ageing.stiffening);
  };
  return ageing.turgor_support * (sunk(max_lost) - sunk(water_lost));
}

double relative_load(const scene::Physiology& ageing, double water_lost) {
  return relative_weight(water_lost) / relative_stiffness(ageing, water_lost);
}

Curve heaviest_load(const scene::Physiology& ageing, const Curve& water) {
  constexpr int steps = 128;
  std::vector<glm::dvec2> points;
  double heaviest = 1.0;
  for (int i = 0; i <= steps; ++i) {
    const double age = static_cast<double>(i) / steps;
    heaviest = std::max(heaviest, relative_load(ageing, 1.0 - water(age)));
    points.emplace_back(age, heaviest);
  }
  return Curve(std::move(points));
}

float snowed_droop(const Blade& blade, float droop, double snow) {
  const double root = std::sqrt(double{blade.length_m});
  const double turned = double{droop} * root;
  const double left = lowest_tip - double{blade.lean} - turned;
  if (left <= 0.0 || snow <= 0.0) return droop;
  const double weighed = turned * snow_per_leaf * snow;
  return droop + static_cast<float>(left * -math::expm1(-weighed / left) / root);
}

BladePose blade_pose(const Blade& blade, const scene::Physiology& ageing, const WaterLoss& lost,
                     double heaviest, double snow) {
  const double water_lost = lost.now;
  const TissueState tissue = tissue_state(ageing, water_lost);
  if (blade.organ != Organ::leaf) return stiff_pose(tissue, snow);
  const double vein = vein_fraction * tissue.modulus_vein_pa;
  const double mesophyll = (1.0 - vein_fraction) * tissue.modulus_mesophyll_pa;
  const double axial =
      (vein * tissue.strain_vein + mesophyll * tissue.strain_mesophyll) / (vein + mesophyll);
  BladePose pose;
  pose.rule = ageing.droop_rule;
  pose.load = static_cast<float>(
      fresh_load(blade) *
      (heaviest + snow_per_leaf * snow / relative_stiffness(ageing, water_lost)));
  pose.droop = blade.fresh_droop +
               blade.droop_rate * static_cast<float>(relieved_loss(lost.max, ageing.stiffening) -
                                                     recovered_loss(ageing, lost.now, lost.max));
  pose.droop = snowed_droop(blade, pose.droop, snow);
  pose.snow = static_cast<float>(snow);
  pose.length_scale = static_cast<float>(linear_scale(axial));
  pose.vein_width = static_cast<float>(linear_scale(tissue.strain_vein));
  pose.mesophyll_width = static_cast<float>(linear_scale(tissue.strain_mesophyll));
  return pose;
}

}  // namespace wold::grass
