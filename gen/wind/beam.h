#pragma once

#include <complex>

#include "wind/profile.h"

namespace wold::wind {

/// A blade as a uniform beam that is clamped at its root and free at its tip.
struct Beam {
  double length_m = 0.0;
  double width_m = 0.0;         ///< that it turns to the wind
  double mass_kg_m = 0.0;       ///< per length, with what it carries
  double stiffness_n_m2 = 0.0;  ///< E I
};

/// Its first natural frequency, 1.8751^2 / (2 pi) sqrt(E I / (m L^4)), Hz (Euler and Bernoulli;
/// [Blevins1979]).
double natural_frequency_hz(const Beam& beam);

/// Its first mode of vibration at `along`, 0 at the root to 1 at the tip, where it is 1.
double first_mode(double along);

/// How far a steady wind of `top_m_s` at the canopy's top bends it in its first mode, the tip's way
/// over its length, by linear theory. The drag per length is 1/2 rho C w U^2, C = 1, and U falls
/// into the canopy as the profile's wind does.
double steady_deflection(const Beam& beam, const Profile& profile, double top_m_s);

/// Damping over the critical one: 0.1 of the blade and its neighbours ([Langre2008]: 0.04 to 0.2
/// are measured of grasses and grain), and that of the air, in which a moving blade has another
/// wind, rho C w U / (2 m omega), U as the mode feels it.
double damping_ratio(const Beam& beam, const Profile& profile, double top_m_s);

/// The answer of a damped oscillator to a force of frequency n over its answer to a steady one:
/// 1 / (1 - r^2 + 2 i zeta r), r = n / natural frequency. Its absolute value is the gain, its
/// argument the lead.
std::complex<double> answer(double frequency_hz, double natural_hz, double damping);

}  // namespace wold::wind
