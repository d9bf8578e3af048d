#pragma once

#include <memory>
#include <optional>

#include "cloud/clouds.h"
#include "core/ground_map.h"
#include "light/daylight.h"
#include "scene/scene.h"
#include "snow/cover.h"
#include "snow/crystal_picture.h"
#include "snow/weather.h"
#include "terrain/lighting.h"

namespace wold::landscape {

/// The snow of a film.
struct Snow {
  Snow(const scene::Scene& scene, const Heightfield& terrain);

  snow::Weather weather;
  snow::FlakePictures pictures;
  snow::SnowGround ground;
};

/// What stays the same from frame to frame: the place and the light of its day.
struct Site {
  Heightfield terrain;
  FactorMap growth;  ///< growth_map()'s
  light::Daylight day;
  terrain::GroundLight light;    ///< under a clear sky
  ColourMap ground_reflectance;  ///< of the bare ground, radiance over irradiance
  std::optional<cloud::Clouds> clouds;
  std::shared_ptr<const Snow> snow;  ///< none where none can fall or lie
};

/// Throws what terrain::make_ground(), growth_map(), cloud::Clouds and Snow's parts throw.
Site make_site(const scene::Scene& scene);

/// Leaf area, one side, of the scene's tapering blades per area of ground.
double leaf_area_index(const scene::Grass& grass);

/// Share of the daylight that reaches the ground between the blades, (0, 1]: Beer and Lambert with
/// the leaf area of the scene's tapering blades and Ross' G = 0.5, along a path 60 degrees off the
/// vertical, the mean of a cosine-weighted hemisphere's secants (2).
double canopy_transmittance(const scene::Grass& grass);

}  // namespace wold::landscape
