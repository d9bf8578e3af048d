#pragma once

namespace wold::wind {

/// Along the mean wind, across it, and up.
enum class Component { along, across, up };

/// One-point spectra of the neutral surface layer ([Kaimal1972], as [Kaimal1994] have them), over
/// the variance along the wind: of f = n z / U, the frequency n at height z where the mean speed
/// is U,
///   n S_u / sigma_u^2 =  22 f   / (1 +  33 f)^(5/3)
///   n S_v / sigma_u^2 =  3.67 f / (1 + 9.5 f)^(5/3)
///   n S_w / sigma_u^2 =  0.45 f / (1 + 5.3 f^(5/3)),
/// which are 102, 17 and 2.1 over the 4.64 that the first has as its integral.
double spectrum(Component component, double f);

/// The part of sigma_u^2 that frequencies up to f have: the integral of spectrum() over ln f. In
/// closed form along and across; upwards by Simpson's rule on 64 steps of f^(1/3), within 1e-5.
double variance_below(Component component, double f);

/// sigma_u over the friction velocity, 2.15.
double deviation_over_friction();

}  // namespace wold::wind
