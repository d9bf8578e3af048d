#include "light/air.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/colour.h"
#include "core/elementary.h"

namespace wold::light {
namespace {

using std::numbers::pi;

/// Amounts of whole columns, upward, over the densities that count as 1.
constexpr double molecules_height_m = 8402.0;
constexpr double aerosol_height_m = 1200.0;
constexpr double ozone_middle_m = 25000.0, ozone_half_m = 15000.0;

/// U.S. Standard Atmosphere 1976: densities in kg/m3 from 0 to 80 km, and logarithms of them over
/// the first.
constexpr double knots_apart_m = 5000.0;
constexpr std::array<double, 17> densities = {1.2250,    0.73643,   0.41351,   0.19476,   0.088910,
                                              0.040084,  0.018410,  0.0084634, 0.0039957, 0.0019663,
                                              0.0010269, 5.6810e-4, 3.0968e-4, 1.6321e-4, 8.2829e-5,
                                              3.9921e-5, 1.8458e-5};

/// The background's optical depth at 0.55 um: above 12 km 0.0022 of it are left, as in quiet years
constexpr double background_depth = 0.010, background_height_m = 8000.0;

/// What aerosol does not absorb (continental average: Hess, Koepke and Schult 1998, OPAC).
constexpr double whole_aerosol_albedo = 0.93;

/// Of the U.S. Standard Atmosphere 1976.
constexpr double ozone_dobson = 343.0;
/// Optical depth of 300 Dobson units, at the wavelengths.
constexpr Spectrum ozone_depth = {0.0001, 0.0003, 0.0010, 0.0024, 0.0051, 0.0096, 0.0151, 0.0236,
                                  0.0313, 0.0366, 0.0392, 0.0324, 0.0237, 0.0165, 0.0108, 0.0068};

/// Means over 20 nm of the sun's spectrum above the air, W/m2 nm (Gueymard 2004, as in ASTM G173).
constexpr Spectrum sun_spectrum = {1.438, 1.702, 1.782, 2.025, 1.980, 1.935, 1.849, 1.872,
                                   1.841, 1.822, 1.767, 1.688, 1.623, 1.539, 1.491, 1.428};
constexpr double extraterrestrial_klx = 133.0;

/// Cornette and Shanks 1992, of an asymmetry `g`.
double cornette_shanks(double cosine, double g) {
  const double base = 1.0 + g * g - 2.0 * g * cosine;
  return 3.0 / (8.0 * pi) * (1.0 - g * g) / (2.0 + g * g) * (1.0 + cosine * cosine) /
         (base * std::sqrt(base));
}

double molecules_at(double height_m) {
  static const auto logarithms = [] {
    std::array<double, densities.size()> of_first{};
    for (std::size_t i = 0; i < of_first.size(); ++i)
      of_first[i] = math::log(densities[i] / densities[0]);
    return of_first;
  }();
  const double step = std::clamp(height_m / knots_apart_m, 0.0, densities.size() - 1.0);
  const std::size_t low = std::min(static_cast<std::size_t>(step), densities.size() - 2);
  const double fraction = step - static_cast<double>(low);
  return math::exp(logarithms[low] + (logarithms[low + 1] - logarithms[low]) * fraction);
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
  return {molecules_at(height_m), math::exp(-height_m / aerosol_height_m),
          math::exp(-height_m / background_height_m),
          std::max(0.0, 1.0 - std::abs(height_m - ozone_middle_m) / ozone_half_m)};
}

Air::Air(double turbidity) : aerosol_albedo_(whole_aerosol_albedo) {
  const auto um = [](std::size_t i) { return wavelength_nm(i) / 1000.0; };
  const double all = 0.04608 * turbidity - 0.04586;
  const double background = background_depth * math::pow(0.55, 1.3);
  molecules_per_m_ = by_wavelength(
      [&](std::size_t i) { return 0.008735 * math::pow(um(i), -4.08) / molecules_height_m; });
  const Spectrum aerosol = by_wavelength([&](std::size_t i) { return math::pow(um(i), -1.3); });
  aerosol_per_m_ = by_wavelength(
      [&](std::size_t i) { return (all - background) * aerosol[i] / aerosol_height_m; });
  background_per_m_ =
      by_wavelength([&](std::size_t i) { return background * aerosol[i] / background_height_m; });
  ozone_per_m_ = by_wavelength(
      [&](std::size_t i) { return ozone_dobson / 300.0 * ozone_depth[i] / ozone_half_m; });
}

Air Air::without_forward_peak(double part) const {
  Air air = *this;
  const double forward = part * forward_fraction;
  const double left = 1.0 - aerosol_albedo_ * forward;
  for (double& per_m : air.aerosol_per_m_) per_m *= left;
  for (double& per_m : air.background_per_m_) per_m *= left;
  air.aerosol_albedo_ *= (1.0 - forward) / left;
  return air;
}

Spectrum Air::extinction_per_m(const AirAmounts& at) const {
  return by_wavelength([&](std::size_t i) {
    return at.molecules * molecules_per_m_[i] + at.aerosol * aerosol_per_m_[i] +
           at.background * background_per_m_[i] + at.ozone * ozone_per_m_[i];
  });
}

Spectrum Air::molecules_scattering_per_m(const AirAmounts& at) const {
  return by_wavelength([&](std::size_t i) { return at.molecules * molecules_per_m_[i]; });
}

Spectrum Air::aerosol_scattering_per_m(const AirAmounts& at) const {
  return by_wavelength([&](std::size_t i) {
    return aerosol_albedo_ *
           (at.aerosol * aerosol_per_m_[i] + at.background * background_per_m_[i]);
  });
}

Spectrum Air::transmittance(const AirAmounts& on_way_m) const {
  const Spectrum depth = extinction_per_m(on_way_m);
  return by_wavelength([&](std::size_t i) { return math::exp(-depth[i]); });
}

double rayleigh_phase(double cosine) { return 3.0 / (16.0 * pi) * (1.0 + cosine * cosine); }

double aerosol_phase(double cosine) {
  constexpr double narrow = 0.0208;
  return narrow * cornette_shanks(cosine, 0.9726) + (1.0 - narrow) * cornette_shanks(cosine, 0.633);
}

SunSpectrum::SunSpectrum() {
  double above = 0.0;
  for (std::size_t i = 0; i < wavelengths; ++i) {
    const double nm = wavelength_nm(i);
    const glm::dvec3 seen = sun_spectrum[i] * observer_fit(nm);
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
