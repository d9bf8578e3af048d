#include "wind/spectrum.h"

#include <cmath>

#include "core/elementary.h"

namespace wold::wind {
namespace {

/// sigma_u^2 over the friction velocity's square: the integral of 102 / (1 + 33 f)^(5/3).
constexpr double variance_along = 102.0 / 33.0 * 1.5;

/// height f / (1 + width f)^(5/3), and its integral over ln f.
struct Blunt {
  double height, width;

  double at(double f) const { return height * f * math::pow(1.0 + width * f, -5.0 / 3.0); }
  double below(double f) const {
    return 1.5 * height / width * (1.0 - math::pow(1.0 + width * f, -2.0 / 3.0));
  }
};

constexpr Blunt along = {102.0 / variance_along, 33.0};
constexpr Blunt across = {17.0 / variance_along, 9.5};

constexpr double up_height = 2.1 / variance_along, up_width = 5.3;

/// spectrum() upwards over f, of r = f^(1/3).
double up_over_f(double r) { return up_height / (1.0 + up_width * math::pow(r, 5.0)); }

/// Its integral over f; df = 3 r^2 dr.
double up_below(double f) {
  constexpr int steps = 64;
  const double last = math::cbrt(f);
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double r = last * i / steps;
    const double weight = i == 0 || i == steps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * 3.0 * r * r * up_over_f(r);
  }
  return sum * last / (3.0 * steps);
}

}  // namespace

double spectrum(Component component, double f) {
  switch (component) {
    case Component::along:
      return along.at(f);
    case Component::across:
      return across.at(f);
    case Component::up:
      return f * up_over_f(math::cbrt(f));
  }
  return 0.0;
}

double variance_below(Component component, double f) {
  switch (component) {
    case Component::along:
      return along.below(f);
    case Component::across:
      return across.below(f);
    case Component::up:
      return up_below(f);
  }
  return 0.0;
}

double deviation_over_friction() { return std::sqrt(variance_along); }

}  // namespace wold::wind
