#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

/// Spectra to colours: CIE 1931 XYZ and linear sRGB (IEC 61966-2-1).
namespace wold {

/// Linear sRGB from XYZ, Y = 1 for white, and back. Not limited to the gamut.
glm::dvec3 srgb_from_xyz(const glm::dvec3& xyz);
glm::dvec3 xyz_from_srgb(const glm::dvec3& rgb);

/// CIE 1976 L*a*b* of XYZ (Y = 1 for white) under D65, the white of sRGB (ISO/CIE 11664-4): L* from
/// 0 to 100.
glm::dvec3 lab_from_xyz(const glm::dvec3& xyz);

/// The sRGB transfer function of one channel, [0, 1] to [0, 1], and back.
double srgb_encoded(double linear);
double srgb_decoded(double encoded);
/// Of three channels.
glm::dvec3 srgb_encoded(const glm::dvec3& linear);

/// Relative luminance Y of a linear sRGB colour; 1 for white.
double luminance(const glm::dvec3& rgb);

/// The colour with all channels in [0, ceiling]: first mixed with the grey of its own luminance,
/// just as much as needed, which keeps hue and luminance; a luminance beyond the range is clamped.
glm::dvec3 in_gamut(const glm::dvec3& rgb, double ceiling = 1.0);

/// The CIE 1931 observer at one wavelength: XYZ up to a common factor, by the multi-lobe fit of
/// Wyman, Sloan and Shirley 2013 (JCGT 2:2, table 1). It serves spectra that are functions, as
/// sunlight's is; those that are tables have an Observer with CIE's own numbers (models/colour).
glm::dvec3 observer_fit(double wavelength_nm);

/// One illuminant and one observer, sampled at a spectrum's wavelengths.
class Observer {
 public:
  /// `matching` are the colour matching functions, `illuminant` the relative power, both at equally
  /// spaced wavelengths. Throws std::invalid_argument when the two differ in length or are empty.
  Observer(std::span<const glm::dvec3> matching, std::span<const double> illuminant);

  /// XYZ of a reflectance, with Y = 1 for the perfect reflector (ISO/CIE 11664-3). One value per
  /// wavelength, else std::invalid_argument.
  glm::dvec3 xyz(std::span<const double> reflectance) const;

  /// Linear sRGB of a reflectance, scaled per channel so that the perfect reflector is (1, 1, 1)
  /// even where the wavelengths do not cover all that is visible. Can leave the gamut.
  glm::dvec3 linear_srgb(std::span<const double> reflectance) const;

 private:
  std::vector<glm::dvec3> weights_xyz_;
  glm::dvec3 white_rgb_;
};

}  // namespace wold
