#pragma once

#include <vector>

#include "grass/optics/shading.h"
#include "place/site.h"
#include "scene/scene.h"

namespace wold::meadow {

/// For how many moments of a film its grass is baked: 1 where the sun stands still; else they are
/// evenly spaced from the first frame of a take to its last, and enough that the sun moves by 10
/// degrees at most between two, by 4 where it sets, on average over its way. Shots of the same time
/// share theirs.
int light_count(const scene::Scene& scene);

/// Where among these moments, from 0 to light_count() - 1, a frame (from 1) lies.
double light_of_frame(const scene::Scene& scene, int frame);

/// The lights that the film's grass is baked for: the days', as overcast as falling snow makes them
/// on average over the frames nearby; of unit irradiance, as what Landscape::light multiplies.
std::vector<grass::Lighting> film_lights(const scene::Scene& scene, const place::Site& site);

/// The light on a frame's grass, between those that it is baked for.
grass::Lighting frame_lighting(const scene::Scene& scene, const place::Site& site, int frame);

}  // namespace wold::meadow
