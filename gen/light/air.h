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

/// Amounts of the three: densities at a height over those at sea level, of ozone over those where
/// it is densest, or such densities summed over a way, in metres.
struct AirAmounts {
  double molecules = 0.0;
  double aerosol = 0.0;
  double ozone = 0.0;
};

/// Densities at a height in metres: molecules and aerosol fall exponentially, to 1 / e over 8 and
/// 1.2 km; ozone lies from 10 to 40 km, most at 25 (Bruneton and Neyret 2008, Precomputed
/// atmospheric scattering; U.S. Standard Atmosphere).
AirAmounts air_at(double height_m);

/// Air of a turbidity, Preetham's T: from 2, clear, to 10, hazy.
///
/// Optical depths of the whole air upward, l in um: molecules 0.008735 l^-4.08, aerosol
/// (0.04608 T - 0.04586) l^-1.3 (Preetham, Shirley and Smits 1999), ozone that of 300 Dobson units
/// (Serdyuchenko et al. 2014, at 233 K).
class Air {
 public:
  /// A turbidity of at least 1: with less there would be less than no aerosol.
  explicit Air(double turbidity);

  /// Extinction, 1/m, by wavelength where the air has these densities.
  Spectrum extinction_per_m(const AirAmounts& at) const;
  /// Scattering by molecules alone, 1/m, and by aerosol alone, where the air has these densities.
  Spectrum molecules_scattering_per_m(const AirAmounts& at) const;
  Spectrum aerosol_scattering_per_m(const AirAmounts& at) const;

  /// Fraction of light that comes through on a way with these amounts, in metres.
  Spectrum transmittance(const AirAmounts& on_way_m) const;

 private:
  Spectrum molecules_per_m_, aerosol_per_m_, ozone_per_m_;
};

/// Fraction of the light they scatter that molecules send into a steradian at an angle of that
/// cosine to its way: 1 over all angles.
double rayleigh_phase(double cosine);

/// Fraction of the light it scatters that continental aerosol sends into a steradian at an angle of
/// that cosine to its way: 1 over all angles (Cornette and Shanks 1992, with an asymmetry of 0.72).
double aerosol_phase(double cosine);

/// Colours of sunlight that was weakened by wavelength. Above the air the sun has Planck's spectrum
/// at 5778 K and lights a plane that faces it with 130 klx.
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
