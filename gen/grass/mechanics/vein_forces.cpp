#include "grass/mechanics/vein_forces.h"

#include <algorithm>

namespace wold::grass {
std::array<double, vein_segments> turns(const VeinPoints& points, double clamp) {
  std::array<double, vein_segments> turn;
  for (std::size_t k = 0; k < turn.size(); ++k)
    turn[k] = points.angle[k] - (k > 0 ? points.angle[k - 1] : clamp);
  return turn;
}

double weight_fraction(double height_m, const VeinLoad& load) {
  return 1.0 + std::min(height_m, 0.0) / (ground_depth * load.length_m);
}

double weighted_height_m(double height_m, const VeinLoad& load) {
  const double sunk_m = std::min(height_m, 0.0);
  return height_m + 0.5 * sunk_m * sunk_m / (ground_depth * load.length_m);
}

JointStiffness joint_stiffness(const VeinLoad& load, std::size_t joint) {
  const double per_m = vein_segments / load.length_m * (joint == 0 ? 2.0 : 1.0);
  return {load.wall_n_m2 * per_m, load.turgor_n_m2 * per_m};
}

double kinetic_j(const VeinPoints& points) {
  double sum = 0.0;
  for (std::size_t i = 0; i < points.mass_kg.size(); ++i)
    sum += 0.5 * points.mass_kg[i] * glm::dot(points.velocity_m_s[i], points.velocity_m_s[i]);
  return sum;
}

double bending_j(const VeinPoints& points, const VeinLoad& load) {
  const auto turn = turns(points, load.clamp);
  double sum = 0.0;
  for (std::size_t k = 0; k < turn.size(); ++k) {
    const JointStiffness stiffness = joint_stiffness(load, k);
    const double bent = turn[k] - load.set[k];
    sum += 0.5 * (stiffness.wall * bent * bent + stiffness.turgor * turn[k] * turn[k]);
  }
  return sum;
}

double height_j(const VeinPoints& points, const VeinLoad& load) {
  double sum = 0.0;
  for (std::size_t i = 0; i < points.mass_kg.size(); ++i)
    sum += points.mass_kg[i] * gravity_m_s2 * weighted_height_m(points.position_m[i].y, load);
  return sum;
}

}  // namespace wold::grass
