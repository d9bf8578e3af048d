#include "cloud/scattering.h"

#include <cmath>
#include <numbers>

namespace wold::cloud {

double henyey_greenstein(double asymmetry, double cosine) {
  const double g = asymmetry;
  const double base = 1.0 + g * g - 2.0 * g * cosine;
  return (1.0 - g * g) / (4.0 * std::numbers::pi * base * std::sqrt(base));
}

TwoStream two_stream(double asymmetry, double depth_before, double depth_behind) {
  const double c = 0.75 * (1.0 - asymmetry);
  const double all = 1.0 + c * (depth_before + depth_behind);
  return {(1.0 + c * depth_behind) / all, c * depth_behind / all};
}

}  // namespace wold::cloud
