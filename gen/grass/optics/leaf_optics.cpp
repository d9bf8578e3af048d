#include "grass/optics/leaf_optics.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "core/angle.h"
#include "core/elementary.h"

namespace wold::grass {
namespace {

/// Half-angle of the incident light's cone, with which PROSPECT's constants were fitted (Jacquemoud
/// and Baret 1990 take 59 degrees; 40 since Feret et al. 2008, Remote Sensing of Environment
/// 112:3030).
constexpr double incidence_deg = 40.0;

/// Fractions of light that a layer sends back and lets through.
struct Layer {
  double reflectance;
  double transmittance;
};

double square(double x) { return x * x; }

/// Transmittance of a plate's inside for diffuse light, absorption coefficient k (Allen et
/// al. 1969, Journal of the Optical Society of America 59:1376).
double plate_transmittance(double k) {
  return k <= 0.0 ? 1.0 : (1.0 - k) * math::exp(-k) + k * k * exponential_integral(k);
}

/// A plate between two surfaces: light enters with transmittance `in`, is reflected inside by the
/// share 1 - `out` and leaves with `out`.
Layer plate(double in, double out, double inside) {
  const double inner = 1.0 - out;
  const double transmittance = in * inside * out / (1.0 - square(inner * inside));
  return {1.0 - in + inner * inside * transmittance, transmittance};
}

/// A pile of `plates` equal plates, any real number (Stokes 1862, Proceedings of the Royal Society
/// 11:545).
Layer pile(const Layer& one, double plates) {
  const double r = one.reflectance;
  const double t = one.transmittance;
  // Nothing is absorbed, up to rounding: the general form would be 0 / 0.
  if (r + t > 1.0 - 1e-12) {
    const double through = t / (t + (1.0 - t) * plates);
    return {1.0 - through, through};
  }
  const double root = std::sqrt((1.0 + r + t) * (1.0 + r - t) * (1.0 - r + t) * (1.0 - r - t));
  const double a = (1.0 + r * r - t * t + root) / (2.0 * r);
  const double b = (1.0 - r * r + t * t + root) / (2.0 * t);
  const double power = math::pow(b, plates);
  const double denominator = square(a * power) - 1.0;
  return {a * (square(power) - 1.0) / denominator, power * (a * a - 1.0) / denominator};
}

/// Absorption of a petal's pigment: a band, Gaussian over the wavelength
/// (models/flower/petals.toml).
double petal_pigment(const LeafContent& leaf, double wavelength_nm) {
  constexpr double band_nm = 42.0;  // its standard deviation
  if (leaf.pigment == 0.0) return 0.0;
  return leaf.pigment * math::exp(-0.5 * square((wavelength_nm - leaf.pigment_nm) / band_nm));
}

/// `top` over `rest`, which light reaches from above; `inner` is what diffuse light from below
/// meets.
Layer stacked(const Layer& top, const Layer& inner, const Layer& rest) {
  const double bounces = 1.0 - rest.reflectance * inner.reflectance;
  return {top.reflectance + top.transmittance * rest.reflectance * inner.transmittance / bounces,
          top.transmittance * rest.transmittance / bounces};
}

/// The two polarisations' integrals of Stern's formula; `a` and `b` are its limits, q = n^2.
double stern_s(double a, double b, double q) {
  const double k = -square(q - 1.0) / 4.0;
  const auto at = [&](double x) { return k * k / (6.0 * x * x * x) + k / x - x / 2.0; };
  return at(b) - at(a);
}

double stern_p(double a, double b, double q) {
  const double p = q + 1.0;
  const double m2 = square(q - 1.0);
  const double p3 = p * p * p;
  const double end = 2.0 * p * b - m2;
  const double start = 2.0 * p * a - m2;
  return -2.0 * q * (b - a) / (p * p) - 2.0 * q * p * math::log(b / a) / m2 +
         q * (1.0 / b - 1.0 / a) / 2.0 +
         16.0 * q * q * (q * q + 1.0) * math::log(end / start) / (p3 * m2) +
         16.0 * q * q * q * (1.0 / end - 1.0 / start) / p3;
}

}  // namespace

double surface_transmittance(double cone_deg, double n) {
  const double q = n * n;
  const double s2 = square(math::sin(radians(cone_deg)));
  const double c = s2 - (q + 1.0) / 2.0;
  // At 90 degrees the root is exactly 0, which rounding would miss.
  const double root =
      cone_deg >= 90.0 ? 0.0 : std::sqrt(std::fmax(0.0, c * c - square(q - 1.0) / 4.0));
  const double a = square(n + 1.0) / 2.0;
  const double b = root - c;
  return (stern_s(a, b, q) + stern_p(a, b, q)) / (2.0 * s2);
}

LeafOptics::LeafOptics(LeafSpectra spectra) : spectra_(std::move(spectra)) {
  for (const double n : spectra_.refractive_index) {
    const double diffuse = surface_transmittance(90.0, n);
    surfaces_.push_back({surface_transmittance(incidence_deg, n), diffuse, diffuse / (n * n)});
  }
}

double LeafOptics::absorption(const LeafContent& leaf, std::size_t wavelength) const {
  return petal_pigment(leaf, spectra_.wavelength_nm[wavelength]) +
         leaf.chlorophyll_ug_cm2 * spectra_.chlorophyll_cm2_ug[wavelength] +
         leaf.carotenoid_ug_cm2 * spectra_.carotenoid_cm2_ug[wavelength] +
         leaf.brown * spectra_.brown[wavelength] + leaf.water_cm * spectra_.water_cm[wavelength] +
         leaf.dry_g_cm2 * spectra_.dry_cm2_g[wavelength];
}

LeafSpectrum LeafOptics::operator()(const LeafContent& leaf) const {
  LeafSpectrum spectrum;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const double inside = plate_transmittance(absorption(leaf, i) / leaf.structure);
    const Layer top = plate(surfaces_[i].from_sun, surfaces_[i].outwards, inside);
    const Layer inner = plate(surfaces_[i].from_diffuse, surfaces_[i].outwards, inside);
    const Layer whole = stacked(top, inner, pile(inner, leaf.structure - 1.0));
    spectrum.reflectance.push_back(whole.reflectance);
    spectrum.transmittance.push_back(whole.transmittance);
  }
  return spectrum;
}

}  // namespace wold::grass
