#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

/// What clear air is made of, by height and wavelength: molecules, aerosol and ozone.
namespace wold::light {

/// One number for each of the wavelengths 400, 420 ... 700 nm.
inline constexpr std::size_t wavelengths = 16;
using Spectrum = std::array<double, wavelengths>;

/// The wavelength of a number below `wavelengths`.
double wavelength_nm(std::size_t number);

/// Of the light that aerosol scatters what goes on nearly as it came: the second moment of
/// aerosol_phase().
inline constexpr double forward_fraction = 0.509;

/// Amounts of the four: densities at a height over those at sea level, of ozone over those where it
/// is densest, or such densities summed over a way, in metres.
struct AirAmounts {
  double molecules = 0.0;
  double aerosol = 0.0;     ///< near the ground, more or less of it by turbidity
  double background = 0.0;  ///< aerosol above that, always the same
  double ozone = 0.0;
};

/// Densities at a height in metres, 0 and more. Molecules: U.S. Standard Atmosphere 1976. Aerosol
/// falls to 1 / e over 1.2 km, its background over 8 km (Hess, Koepke and Schult 1998, OPAC). Ozone
/// lies from 10 to 40 km, most at 25 (Bruneton and Neyret 2008, Precomputed atmospheric
/// scattering).
AirAmounts air_at(double height_m);

/// Air of a turbidity, Preetham's T: from 2, clear, to 10, hazy.
///
/// Optical depths of the whole air upward, l in um: molecules 0.008735 l^-4.08, aerosol
/// (0.04608 T - 0.04586) l^-1.3 (Preetham, Shirley and Smits 1999), of which 0.010 at 0.55 um are
/// background, 0.0022 of them above 12 km as in years without volcanoes (Sato and others 1993),
/// ozone that of 343 Dobson units (U.S. Standard Atmosphere; Serdyuchenko et al. 2014, at 233 K).
class Air {
 public:
  /// A turbidity of at least 1.2: with less there would be less than no aerosol.
  explicit Air(double turbidity);

  /// The same air for light on its way through many scatterings: the forward_fraction of what
  /// aerosol scatters counts as not scattered (delta-M, Wiscombe 1977), or a
  /// `part` of it, in [0, 1].
  Air without_forward_peak(double part = 1.0) const;

  /// Extinction, 1/m, by wavelength where the air has these densities.
  Spectrum extinction_per_m(const AirAmounts& at) const;
  /// Scattering by molecules alone, 1/m, and by aerosol alone, where the air has these densities.
  Spectrum molecules_scattering_per_m(const AirAmounts& at) const;
  Spectrum aerosol_scattering_per_m(const AirAmounts& at) const;

  /// Fraction of light that comes through on a way with these amounts, in metres.
  Spectrum transmittance(const AirAmounts& on_way_m) const;

 private:
  Spectrum molecules_per_m_, aerosol_per_m_, background_per_m_, ozone_per_m_;
  double aerosol_albedo_;
};

/// Fraction of the light they scatter that molecules send into a steradian at an angle of that
/// cosine to its way: 1 over all angles.
double rayleigh_phase(double cosine);

/// Fraction of the light it scatters that continental aerosol sends into a steradian at an angle of
/// that cosine to its way: 1 over all angles. Two lobes of Cornette and Shanks 1992, fitted to the
/// Mie scattering of OPAC's average continental aerosol at 80 % of humidity and 550 nm, within 7 %
/// from 0.5 to 50 degrees and within 23 % at all angles.
double aerosol_phase(double cosine);

/// Colours of sunlight that was weakened by wavelength. Above the air the sun has the spectrum of
/// Gueymard 2004 and lights a plane that faces it with 133 klx (Darula, Kittler and Gueymard 2005).
class SunSpectrum {
 public:
  SunSpectrum();
  /// Illuminance in klx, as linear sRGB, of a plane that faces the sun where these fractions of its
  /// light arrive.
  glm::dvec3 klx(const Spectrum& fraction) const;

 private:
  std::array<glm::dvec3, wavelengths> rgb_klx_;
};

}  // namespace wold::light
