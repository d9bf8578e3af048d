#pragma once

#include "landscape/landscape.h"
#include "landscape/needs.h"
#include "place/site.h"
#include "scene/scene.h"
#include "sky/precipitation_medium.h"

namespace wold::sky {

/// Extinction of the snow and rain in a frame's (from 1) air where its camera is, as it is seen; 0
/// when none falls.
double falling_extinction_per_m(const scene::Scene& scene, const place::Site& site, int frame);

/// That of what makes a frame's sky grey: the mean_of_nearby() frames.
double overcast_extinction_per_m(const scene::Scene& scene, const place::Site& site, int frame);

/// Sets the flakes and drops before the landscape's camera and the fog that stands for all others,
/// in that light, and shows its sky through them. Its frame, camera, terrain and size have to be
/// set. Flakes behind each other keep to what exporters need.
void add_precipitation(const scene::Scene& scene, const place::Site& site,
                       const PrecipitationMedium& air, const landscape::Needs& needs,
                       landscape::Landscape& landscape);

}  // namespace wold::sky
