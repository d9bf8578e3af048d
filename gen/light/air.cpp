#include "light/air.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/colour.h"
#include "core/elementary.h"

namespace wold::light {
namespace {

using std::numbers::pi;

constexpr double molecules_height_m = 8000.0;
constexpr double aerosol_height_m = 1200.0;
constexpr double ozone_middle_m = 25000.0, ozone_half_m = 15000.0;

/// What aerosol does not absorb (continental average: Hess, Koepke and Schult 1998, OPAC).
constexpr double aerosol_albedo = 0.93;

/// Optical depth of 300 Dobson units, at the wavelengths.
constexpr Spectrum ozone_depth = {0.0001, 0.0003, 0.0010, 0.0024, 0.0051, 0.0096, 0.0151, 0.0236,
                                  0.0313, 0.0366, 0.0392, 0.0324, 0.0237, 0.0165, 0.0108, 0.0068};

constexpr double extraterrestrial_klx = 130.0;  // between the 127.5 and 133.1 of the literature

/// Planck's law up to a factor.
double sun_spectrum(double nm) {
  constexpr double sun_temperature_K = 5778.0;
  constexpr double second_radiation_constant_nm_K = 1.438777e7;
  return math::pow(nm / 500.0, -5.0) /
         (math::exp(second_radiation_constant_nm_K / (nm * sun_temperature_K)) - 1.0);
}

template <class Value>
Spectrum by_wavelength(const Value& value) {
  Spectrum spectrum;
  for (std::size_t i = 0; i < wavelengths; ++i) spectrum[i] = value(i);
  return spectrum;
}

}  // namespace

double wavelength_nm(std::size_t number) { return 400.0 + 20.0 * static_cast<double>(number); }

AirAmounts air_at(double height_m) {
  return {math::exp(-height_m / molecules_height_m), math::exp(-height_m / aerosol_height_m),
          std::max(0.0, 1.0 - std::abs(height_m - ozone_middle_m) / ozone_half_m)};
}

Air::Air(double turbidity) {
  const double aerosol = 0.04608 * turbidity - 0.04586;
  const auto um = [](std::size_t i) { return wavelength_nm(i) / 1000.0; };
  molecules_per_m_ = by_wavelength(
      [&](std::size_t i) { return 0.008735 * math::pow(um(i), -4.08) / molecules_height_m; });
  aerosol_per_m_ = by_wavelength(
      [&](std::size_t i) { return aerosol * math::pow(um(i), -1.3) / aerosol_height_m; });
  ozone_per_m_ = by_wavelength([&](std::size_t i) { return ozone_depth[i] / ozone_half_m; });
}

Spectrum Air::extinction_per_m(const AirAmounts& at) const {
  return by_wavelength([&](std::size_t i) {
    return at.molecules * molecules_per_m_[i] + at.aerosol * aerosol_per_m_[i] +
           at.ozone * ozone_per_m_[i];
  });
}

Spectrum Air::molecules_scattering_per_m(const AirAmounts& at) const {
  return by_wavelength([&](std::size_t i) { return at.molecules * molecules_per_m_[i]; });
}

Spectrum Air::aerosol_scattering_per_m(const AirAmounts& at) const {
  return by_wavelength(
      [&](std::size_t i) { return aerosol_albedo * at.aerosol * aerosol_per_m_[i]; });
}

Spectrum Air::transmittance(const AirAmounts& on_way_m) const {
  const Spectrum depth = extinction_per_m(on_way_m);
  return by_wavelength([&](std::size_t i) { return math::exp(-depth[i]); });
}

double rayleigh_phase(double cosine) { return 3.0 / (16.0 * pi) * (1.0 + cosine * cosine); }

double aerosol_phase(double cosine) {
  constexpr double g = 0.72;
  const double base = 1.0 + g * g - 2.0 * g * cosine;
  return 3.0 / (8.0 * pi) * (1.0 - g * g) / (2.0 + g * g) * (1.0 + cosine * cosine) /
         (base * std::sqrt(base));
}

SunSpectrum::SunSpectrum() {
  double above = 0.0;
  for (std::size_t i = 0; i < wavelengths; ++i) {
    const double nm = wavelength_nm(i);
    const glm::dvec3 seen = sun_spectrum(nm) * observer_fit(nm);
    rgb_klx_[i] = srgb_from_xyz(seen);
    above += seen.y;
  }
  for (glm::dvec3& rgb : rgb_klx_) rgb *= extraterrestrial_klx / above;
}

glm::dvec3 SunSpectrum::klx(const Spectrum& fraction) const {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < wavelengths; ++i) sum += fraction[i] * rgb_klx_[i];
  return sum;
}

}  // namespace wold::light
