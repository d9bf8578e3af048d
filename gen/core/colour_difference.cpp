#include "core/colour_difference.h"

#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"

namespace wold {
namespace {

using std::numbers::pi;

/// sqrt(C^7 / (C^7 + 25^7)): near 1 for saturated colours, 0 for greys.
double saturation(double chroma) {
  const double power = math::pow(chroma, 7.0);
  return std::sqrt(power / (power + math::pow(25.0, 7.0)));
}

/// Lightness, chroma and hue in radians from 0 to 2 pi.
struct Polar {
  double lightness, chroma, hue;
};

Polar polar(const glm::dvec3& lab, double stretch) {
  const double a = lab.y * stretch;
  const double hue = a == 0.0 && lab.z == 0.0 ? 0.0 : math::atan2(lab.z, a);
  return {lab.x, math::hypot(a, lab.z), hue < 0.0 ? hue + 2.0 * pi : hue};
}

/// The way from one hue to the other, the short way round; 0 where a colour is grey.
double hue_step(const Polar& from, const Polar& to) {
  if (from.chroma * to.chroma == 0.0) return 0.0;
  return std::remainder(to.hue - from.hue, 2.0 * pi);
}

double mean_hue(const Polar& one, const Polar& other) {
  const double sum = one.hue + other.hue;
  if (one.chroma * other.chroma == 0.0) return sum;
  if (std::abs(one.hue - other.hue) <= pi) return sum / 2.0;
  return sum < 2.0 * pi ? sum / 2.0 + pi : sum / 2.0 - pi;
}

double hue_weight(double hue) {
  return 1.0 - 0.17 * math::cos(hue - radians(30.0)) + 0.24 * math::cos(2.0 * hue) +
         0.32 * math::cos(3.0 * hue + radians(6.0)) - 0.20 * math::cos(4.0 * hue - radians(63.0));
}

/// How much differences in chroma and hue turn into each other, around blue.
double rotation(double chroma, double hue) {
  const double distance = (degrees(hue) - 275.0) / 25.0;
  return -2.0 * saturation(chroma) * math::sin(radians(60.0) * math::exp(-distance * distance));
}

}  // namespace

double colour_difference(const glm::dvec3& lab, const glm::dvec3& other) {
  const double plain = (math::hypot(lab.y, lab.z) + math::hypot(other.y, other.z)) / 2.0;
  const double stretch = 1.5 - 0.5 * saturation(plain);
  const Polar one = polar(lab, stretch);
  const Polar two = polar(other, stretch);
  const double chroma = (one.chroma + two.chroma) / 2.0;
  const double hue = mean_hue(one, two);
  const double off = math::pow((one.lightness + two.lightness) / 2.0 - 50.0, 2.0);

  const double lightness_part =
      (two.lightness - one.lightness) / (1.0 + 0.015 * off / std::sqrt(20.0 + off));
  const double chroma_part = (two.chroma - one.chroma) / (1.0 + 0.045 * chroma);
  const double hue_part = 2.0 * std::sqrt(one.chroma * two.chroma) *
                          math::sin(hue_step(one, two) / 2.0) /
                          (1.0 + 0.015 * chroma * hue_weight(hue));
  return std::sqrt(lightness_part * lightness_part + chroma_part * chroma_part +
                   hue_part * hue_part + rotation(chroma, hue) * chroma_part * hue_part);
}

}  // namespace wold
