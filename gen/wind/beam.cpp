#include "wind/beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold::wind {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
/// First root of cos(x) cosh(x) = -1.
constexpr double first_root = 1.8751040687119611;
constexpr double air_kg_m3 = 1.2;
constexpr double drag_coefficient = 1.0;
constexpr double own_damping = 0.1;

/// The mean over the blade's length of value(along), by Simpson's rule.
template <class Value>
double mean_along(const Value& value) {
  constexpr int steps = 32;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double weight = i == 0 || i == steps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * value(static_cast<double>(i) / steps);
  }
  return sum / (3.0 * steps);
}

/// The wind at `along` an upright blade over that at the canopy's top.
double sheltered(const Beam& beam, const Profile& profile, double along) {
  return profile.at(std::min(along * beam.length_m, profile.canopy_m())) / profile.at_top();
}

double square(double x) { return x * x; }

/// The first mode's mass per length, kg/m.
double modal_mass_kg_m(const Beam& beam) {
  return beam.mass_kg_m * mean_along([](double along) { return square(first_mode(along)); });
}

}  // namespace

double first_mode(double along) {
  const double x = first_root * along;
  const auto cosh = [](double y) { return 0.5 * (math::exp(y) + math::exp(-y)); };
  const auto sinh = [](double y) { return 0.5 * (math::exp(y) - math::exp(-y)); };
  const double ratio =
      (cosh(first_root) + math::cos(first_root)) / (sinh(first_root) + math::sin(first_root));
  return 0.5 * (cosh(x) - math::cos(x) - ratio * (sinh(x) - math::sin(x)));
}

double natural_frequency_hz(const Beam& beam) {
  return square(first_root / beam.length_m) / two_pi *
         std::sqrt(beam.stiffness_n_m2 / beam.mass_kg_m);
}

double steady_deflection(const Beam& beam, const Profile& profile, double top_m_s) {
  const double force = mean_along(
      [&](double along) { return square(sheltered(beam, profile, along)) * first_mode(along); });
  const double drag_n_m = 0.5 * air_kg_m3 * drag_coefficient * beam.width_m * square(top_m_s);
  const double stiffness_n_m2 = modal_mass_kg_m(beam) * square(two_pi * natural_frequency_hz(beam));
  return drag_n_m * force / (stiffness_n_m2 * beam.length_m);
}

double damping_ratio(const Beam& beam, const Profile& profile, double top_m_s) {
  const double felt = mean_along(
      [&](double along) { return sheltered(beam, profile, along) * square(first_mode(along)); });
  const double by_air = air_kg_m3 * drag_coefficient * beam.width_m * top_m_s * felt;
  return own_damping + by_air / (2.0 * modal_mass_kg_m(beam) * two_pi * natural_frequency_hz(beam));
}

std::complex<double> answer(double frequency_hz, double natural_hz, double damping) {
  const double r = frequency_hz / natural_hz;
  const double real = 1.0 - r * r, imaginary = 2.0 * damping * r;
  const double norm = real * real + imaginary * imaginary;
  return {real / norm, -imaginary / norm};
}

}  // namespace wold::wind
