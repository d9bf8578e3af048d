#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"

namespace wold::terrain {

/// Steepest ascent (dz/dx, dz/dy) at a point, by central differences over two grid steps; one-sided
/// at the border; beyond it, that of the border.
glm::dvec2 gradient(const Heightfield& terrain, double x_m, double y_m);

/// Upward unit normal at a point.
glm::dvec3 normal(const Heightfield& terrain, double x_m, double y_m);

/// The heights of the mesh that renderers make of a terrain (mesh_height_m()), on another grid.
Heightfield mesh_heights(const Heightfield& terrain, const GroundGrid& grid);

/// Angle between the ground and the horizontal, degrees in [0, 90).
double slope_deg(const Heightfield& terrain, double x_m, double y_m);

/// Azimuth in which the ground falls, degrees clockwise from north in [0, 360); 0 on level ground.
double aspect_deg(const Heightfield& terrain, double x_m, double y_m);

}  // namespace wold::terrain
