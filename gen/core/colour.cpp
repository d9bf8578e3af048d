#include "core/colour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "core/elementary.h"

namespace wold {
namespace {

// IEC 61966-2-1:1999; the columns are X, Y and Z.
const glm::dmat3 srgb_xyz_matrix(3.2406, -0.9689, 0.0557,   //
                                 -1.5372, 1.8758, -0.2040,  //
                                 -0.4986, 0.0415, 1.0570);
const glm::dmat3 xyz_srgb_matrix = glm::inverse(srgb_xyz_matrix);

/// The cube root with CIE's linear foot.
double lab_curve(double t) {
  constexpr double foot = 6.0 / 29.0;
  return t > foot * foot * foot ? math::cbrt(t) : t / (3.0 * foot * foot) + 4.0 / 29.0;
}

/// Fraction of grey that brings one channel into [0, ceiling].
double grey_needed(double channel, double grey, double ceiling) {
  if (channel < 0.0) return -channel / (grey - channel);
  if (channel > ceiling) return (channel - ceiling) / (channel - grey);
  return 0.0;
}

double lobe(double wavelength_nm, double centre_nm, double left_per_nm, double right_per_nm) {
  const double from_centre_nm = wavelength_nm - centre_nm;
  const double t = from_centre_nm * (from_centre_nm < 0.0 ? left_per_nm : right_per_nm);
  return math::exp(-0.5 * t * t);
}

}  // namespace

glm::dvec3 srgb_from_xyz(const glm::dvec3& xyz) { return srgb_xyz_matrix * xyz; }

glm::dvec3 xyz_from_srgb(const glm::dvec3& rgb) { return xyz_srgb_matrix * rgb; }

glm::dvec3 lab_from_xyz(const glm::dvec3& xyz) {
  const glm::dvec3 ratio = xyz / xyz_from_srgb(glm::dvec3(1.0));
  const glm::dvec3 f(lab_curve(ratio.x), lab_curve(ratio.y), lab_curve(ratio.z));
  return {116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z)};
}

double srgb_encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * math::pow(linear, 1.0 / 2.4) - 0.055;
}

double srgb_decoded(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : math::pow((encoded + 0.055) / 1.055, 2.4);
}

glm::dvec3 srgb_encoded(const glm::dvec3& linear) {
  return {srgb_encoded(linear.r), srgb_encoded(linear.g), srgb_encoded(linear.b)};
}

double luminance(const glm::dvec3& rgb) {
  return glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));  // ITU-R BT.709
}

glm::dvec3 in_gamut(const glm::dvec3& rgb, double ceiling) {
  const double grey = std::clamp(luminance(rgb), 0.0, ceiling);
  double fraction = 0.0;
  for (int i = 0; i < 3; ++i) fraction = std::max(fraction, grey_needed(rgb[i], grey, ceiling));
  return glm::clamp(glm::mix(rgb, glm::dvec3(grey), fraction), 0.0, ceiling);
}

glm::dvec3 observer_fit(double nm) {
  return {0.362 * lobe(nm, 442.0, 0.0624, 0.0374) + 1.056 * lobe(nm, 599.8, 0.0264, 0.0323) -
              0.065 * lobe(nm, 501.1, 0.0490, 0.0382),
          0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
          1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725)};
}

Observer::Observer(std::span<const glm::dvec3> matching, std::span<const double> illuminant) {
  if (matching.empty() || matching.size() != illuminant.size())
    throw std::invalid_argument("matching functions and illuminant differ in wavelengths");
  double luminous = 0.0;
  for (std::size_t i = 0; i < matching.size(); ++i) luminous += matching[i].y * illuminant[i];
  for (std::size_t i = 0; i < matching.size(); ++i)
    weights_xyz_.push_back(matching[i] * (illuminant[i] / luminous));
  white_rgb_ = srgb_from_xyz(xyz(std::vector<double>(matching.size(), 1.0)));
}

glm::dvec3 Observer::xyz(std::span<const double> reflectance) const {
  if (reflectance.size() != weights_xyz_.size())
    throw std::invalid_argument("the spectrum does not have the observer's wavelengths");
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < reflectance.size(); ++i) sum += weights_xyz_[i] * reflectance[i];
  return sum;
}

glm::dvec3 Observer::linear_srgb(std::span<const double> reflectance) const {
  return srgb_from_xyz(xyz(reflectance)) / white_rgb_;
}

}  // namespace wold
