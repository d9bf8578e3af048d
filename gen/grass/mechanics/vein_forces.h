#pragma once

#include <array>

#include "grass/mechanics/vein.h"

namespace wold::grass {

/// What acts on the points of a vein besides their weight. The blade neither stretches nor shrinks
/// under its load (its weight strains it by 1e-5): the stresses of its tissues balance along it
/// and set `length_m`, see axial_shrinkage().
struct VeinLoad {
  double length_m = 0.0;
  double clamp = 0.0;        ///< angle from the vertical in which the root is held, rad
  double wall_n_m2 = 0.0;    ///< E I of the cell walls
  double turgor_n_m2 = 0.0;  ///< E I that turgor adds, of a blade that it holds straight
  std::array<double, vein_segments> set{};  ///< turn at each joint at which the walls rest, rad
  double bending_damping_s = 0.01;  ///< Kelvin and Voigt's: moment E I times this per turning speed
  double air_damping_per_s = 2.0;   ///< of the velocities
};

inline constexpr double gravity_m_s2 = 9.81;

/// How deep a point sinks into the ground that bears its own weight, in lengths of the blade: the
/// ground is a spring.
inline constexpr double ground_depth = 0.002;

/// Angle by which a vein turns at each joint; the first is that between the clamp and the first
/// segment, half a segment long.
std::array<double, vein_segments> turns(const VeinPoints& points, double clamp);

/// Weight of a point less what the ground bears of it, over its mass times gravity: 1 above the
/// ground, negative where it pushes more than the point weighs.
double weight_fraction(double height_m, const VeinLoad& load);
/// Its integral from the ground up: energy over mass times gravity.
double weighted_height_m(double height_m, const VeinLoad& load);

/// Moments in the joints over their turns: E I per length, walls and turgor.
struct JointStiffness {
  double wall, turgor;
};
JointStiffness joint_stiffness(const VeinLoad& load, std::size_t joint);

/// Energies, joules: of motion; of bending; of height, with that of the ground's spring.
double kinetic_j(const VeinPoints& points);
double bending_j(const VeinPoints& points, const VeinLoad& load);
double height_j(const VeinPoints& points, const VeinLoad& load);

}  // namespace wold::grass
