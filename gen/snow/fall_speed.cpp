#include "snow/fall_speed.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace wold::snow {
namespace {

struct Law {
  double a;
  double b;
  double min_mm;
  double greatest_mm;
};

/// Locatelli and Hobbs's rows, in the order of Crystal.
constexpr std::array<Law, crystal_kinds> laws = {{
    {0.69, 0.41, 0.2, 3.0},   // assemblages of plates, side planes, bullets and columns
    {0.69, 0.41, 0.2, 3.0},   // the same
    {0.62, 0.33, 1.8, 4.0},   // densely rimed dendrites, the only single ones
    {0.80, 0.16, 2.0, 10.0},  // aggregates of unrimed dendrites
}};

std::array<double, crystal_kinds> mixed_fractions(double diameter_mm) {
  constexpr double first_aggregates_mm = 1.5, mostly_aggregates_mm = 5.0;  // our choice
  constexpr double dendrites = 0.15, max_aggregates = 0.8, plates = 0.6;
  const double grown = std::clamp(
      (diameter_mm - first_aggregates_mm) / (mostly_aggregates_mm - first_aggregates_mm), 0.0, 1.0);
  const double aggregates = max_aggregates * grown;
  const double rest = 1.0 - dendrites - aggregates;
  return {plates * rest, (1.0 - plates) * rest, dendrites, aggregates};
}

}  // namespace

double fall_speed_m_s(Crystal crystal, double diameter_mm) {
  const Law& law = laws[static_cast<std::size_t>(crystal)];
  return law.a * math::pow(std::clamp(diameter_mm, law.min_mm, law.greatest_mm), law.b);
}

std::array<double, crystal_kinds> crystal_fractions(scene::CrystalChoice choice,
                                                    double diameter_mm) {
  if (choice == scene::CrystalChoice::mixed) return mixed_fractions(diameter_mm);
  std::array<double, crystal_kinds> fractions = {};
  for (std::size_t crystal = 0; crystal < crystal_kinds; ++crystal)
    fractions[crystal] = single_crystals[crystal] == choice ? 1.0 : 0.0;
  return fractions;
}

Crystal picked_crystal(const std::array<double, crystal_kinds>& fractions, double uniform) {
  std::size_t crystal = 0;
  double sum = fractions[0];
  while (uniform >= sum && crystal + 1 < crystal_kinds) sum += fractions[++crystal];
  return static_cast<Crystal>(crystal);
}

}  // namespace wold::snow
