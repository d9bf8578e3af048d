#include "wind/streamlining.h"

#include <algorithm>

#include "core/elementary.h"

namespace wold::wind {

double leaning_rad(double load) {
  // theta - load cos^2 theta rises; Newton's method from the left of the root.
  double theta = load / (1.0 + load);
  for (int step = 0; step < 6; ++step) {
    const double cosine = math::cos(theta), sine = math::sin(theta);
    theta -= (theta - load * cosine * cosine) / (1.0 + 2.0 * load * sine * cosine);
  }
  return theta;
}

double load_of(double leaning_rad) {
  const double cosine = math::cos(leaning_rad);
  return leaning_rad / (cosine * cosine);
}

glm::dvec2 leaning_under(const glm::dvec2& lean, const glm::dvec2& load) {
  const double height = glm::length(lean);
  glm::dvec2 sum = load;
  if (height > 0.0) sum += load_of(math::atan(height)) / height * lean;
  const double whole = glm::length(sum);
  if (whole == 0.0) return glm::dvec2(0.0);
  return math::tan(leaning_rad(whole)) / whole * sum;
}

}  // namespace wold::wind
