#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "landscape/landscape.h"

namespace wold::landscape {

/// How many maps of the light on its grass a frame has.
int count_light_maps(const Landscape& landscape);

/// The map of that number: 0 is Landscape::light, the others are its Landscape::light_details from
/// 1 on, each finer than the one before it and on a smaller square. Throws std::out_of_range for a
/// number that there is none of.
const ColourMap& light_map(const Landscape& landscape, int number);

/// The number of the finest map that covers a patch with that middle and half a patch around it.
int light_map_at(const Landscape& landscape, const glm::dvec2& middle_m);

/// The number of the map that a cell takes its light from, by its Cell::world_from_cell or
/// BladeCell::world_from_cell.
int light_map_of(const Landscape& landscape, const glm::dmat4& world_from_cell);

/// The light at a place, of the map that light_map_at() says.
glm::vec3 light_on_grass(const Landscape& landscape, const glm::dvec2& at_m);

/// Landscape::extinction_factor as it multiplies what one of the maps lights, on the same grid as
/// standing_light() of that number.
FactorMap standing_fraction(const Landscape& landscape, int number);

/// The light on what stands: a map of that number times the extinction factor, on the map's square,
/// at least as fine as it is.
ColourMap standing_light(const Landscape& landscape, int number);

}  // namespace wold::landscape
