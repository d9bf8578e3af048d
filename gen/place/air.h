#pragma once

#include <memory>

#include "core/ground_map.h"
#include "scene/scene.h"
#include "snow/weather.h"
#include "wind/air_flow.h"

namespace wold::place {

/// Whether a scene's grass moves in the wind of the moment. Hair lies as it is combed.
bool grass_waves(const scene::Scene& scene);

/// The wind over a scene's ground, as [wind] has it: the grass is as high as the mean of its
/// species, and the air is without gusts where wind.field is "steady".
std::shared_ptr<const wind::AirFlow> air_flow(const scene::Scene& scene,
                                              const Heightfield& terrain);

/// The wind over snow, as smooth as that is, with the gusts of the wind over grass.
std::shared_ptr<const wind::AirFlow> air_over_snow(const scene::Scene& scene,
                                                   const Heightfield& terrain);

/// The mean wind so long after the film's first frame.
wind::Moment mean_wind(const snow::Weather& weather, double time_s);

}  // namespace wold::place
