#include "terrain/relief.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wold::terrain {
namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

}  // namespace

glm::dvec2 gradient(const Heightfield& terrain, double x_m, double y_m) {
  const auto inside = [&](double at_m) { return std::clamp(at_m, 0.0, terrain.size_m()); };
  const double west = inside(inside(x_m) - terrain.step_m());
  const double east = inside(inside(x_m) + terrain.step_m());
  const double south = inside(inside(y_m) - terrain.step_m());
  const double north = inside(inside(y_m) + terrain.step_m());
  return {(terrain.sample(east, y_m) - terrain.sample(west, y_m)) / (east - west),
          (terrain.sample(x_m, north) - terrain.sample(x_m, south)) / (north - south)};
}

glm::dvec3 normal(const Heightfield& terrain, double x_m, double y_m) {
  return glm::normalize(glm::dvec3(-gradient(terrain, x_m, y_m), 1.0));
}

double slope_deg(const Heightfield& terrain, double x_m, double y_m) {
  return std::atan(glm::length(gradient(terrain, x_m, y_m))) * degrees_per_radian;
}

double aspect_deg(const Heightfield& terrain, double x_m, double y_m) {
  const glm::dvec2 down = -gradient(terrain, x_m, y_m);
  if (down.x == 0.0 && down.y == 0.0) return 0.0;
  const double azimuth_deg = std::atan2(down.x, down.y) * degrees_per_radian;
  return azimuth_deg < 0.0 ? azimuth_deg + 360.0 : azimuth_deg;
}

}  // namespace wold::terrain
