#pragma once

#include "grass/shading.h"
#include "landscape/site.h"
#include "scene/scene.h"

namespace wold::landscape {

/// The light that the film's grass is baked for: the day's, as overcast as falling snow makes it on
/// average over the frames; of unit irradiance, as what Landscape::light multiplies.
grass::Lighting film_lighting(const scene::Scene& scene, const Site& site);

}  // namespace wold::landscape
