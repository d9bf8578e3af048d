#include "terrain/relief.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/mesh_height.h"
#include "core/parallel.h"

namespace wold::terrain {

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

Heightfield mesh_heights(const Heightfield& terrain, const GroundGrid& grid) {
  Heightfield heights_m(grid.samples, grid.square);
  parallel_for(static_cast<std::size_t>(grid.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < grid.samples; ++i)
      heights_m.at(i, j) = mesh_height_m(terrain, heights_m.place_m(i, j));
  });
  return heights_m;
}

double slope_deg(const Heightfield& terrain, double x_m, double y_m) {
  return math::atan(glm::length(gradient(terrain, x_m, y_m))) * degrees_per_radian;
}

double aspect_deg(const Heightfield& terrain, double x_m, double y_m) {
  const glm::dvec2 down = -gradient(terrain, x_m, y_m);
  if (down.x == 0.0 && down.y == 0.0) return 0.0;
  const double azimuth_deg = math::atan2(down.x, down.y) * degrees_per_radian;
  return azimuth_deg < 0.0 ? azimuth_deg + 360.0 : azimuth_deg;
}

}  // namespace wold::terrain
