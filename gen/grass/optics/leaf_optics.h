#pragma once

#include <vector>

#include "grass/optics/pigments.h"

namespace wold::grass {

/// What a leaf is made of.
struct LeafContent {
  double structure = 1.5;  ///< N: number of plates, 1 to 3; more air spaces, more plates
  double chlorophyll_ug_cm2 = 0.0;
  double carotenoid_ug_cm2 = 0.0;
  double brown = 0.0;         ///< arbitrary units: 0 living, 1 to 2 brown
  double water_cm = 0.0;      ///< thickness of the water alone
  double dry_g_cm2 = 0.0;     ///< dry mass per area; more than 0
  double pigment = 0.0;       ///< of a petal: depth at the middle of its band, natural logarithm
  double pigment_nm = 550.0;  ///< where that is
};

/// What a leaf does with light, one value per wavelength, as fractions of the incident light.
struct LeafSpectrum {
  std::vector<double> reflectance;
  std::vector<double> transmittance;
};

/// The exponential integral E1(x), x > 0.
double exponential_integral(double x);

/// Mean transmittance of a surface into a medium of refractive index n > 1 for unpolarised light
/// from the cone of half-angle `cone_deg` in (0, 90] (Stern 1964, Applied Optics 3:111; Allen 1973,
/// Journal of the Optical Society of America 63:664).
double surface_transmittance(double cone_deg, double n);

/// PROSPECT-D: a leaf as a pile of N absorbing plates (Jacquemoud and Baret 1990, Remote Sensing of
/// Environment 34:75; pigments of Feret et al. 2017, 193:204).
class LeafOptics {
 public:
  explicit LeafOptics(LeafSpectra spectra);

  LeafSpectrum operator()(const LeafContent& leaf) const;

  const LeafSpectra& spectra() const { return spectra_; }

 private:
  /// Transmittances of the surface at one wavelength.
  struct Surface {
    double from_sun;      ///< light from a cone of 40 degrees enters
    double from_diffuse;  ///< diffuse light enters
    double outwards;      ///< diffuse light leaves
  };
  double absorption(const LeafContent& leaf, std::size_t wavelength) const;

  LeafSpectra spectra_;
  std::vector<Surface> surfaces_;
};

}  // namespace wold::grass
