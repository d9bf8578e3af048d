#pragma once

#include "scene/scene.h"
#include "scene/shots.h"

/// The parts of a scene, one for each phenomenon: what its physics may know. A function that takes
/// a part can be called with a scene.
namespace wold::scene {

/// Of the meadow's plants: a copy, so that it may be kept.
struct MeadowPart {
  std::uint64_t seed;
  Grass grass;
  Ageing ageing;
  std::vector<Species> species;  ///< as in Scene
  std::vector<Take> takes;       ///< of shots, into which ageing.frames fall; empty: without cuts

  MeadowPart(const Scene& scene);
};

// The parts below refer to the scene. They are for parameters alone: who needs something of them
// for longer copies it.

/// Of a season's days: what they are like, and what they are like where nothing says so.
struct SeasonPart {
  const Season& season;  ///< without a first day where the scene is no season
  const std::vector<SeasonKey>& keys;
  const Weather& weather;
  const Wind& wind;
  double latitude_deg;
  double visual_range_m;

  SeasonPart(const Scene& scene);
};

/// Of the weather by the hour.
struct WeatherPart {
  const Weather& weather;
  const Wind& wind;
  SnowfallStrength strength;
  double latitude_deg;

  WeatherPart(const Scene& scene);
};

/// Of flakes and drops in the air.
struct PrecipitationPart {
  std::uint64_t seed;
  const Snowfall& snowfall;
  const Rainfall& rainfall;
  const Wind& wind;
  double terrain_m;  ///< side of the terrain's square

  PrecipitationPart(const Scene& scene);
};

/// Of snow on the ground.
struct SnowCoverPart {
  std::uint64_t seed;
  const SnowCover& cover;
  double earlier_h;  ///< for how long the weather had lasted at the first frame
  double film_s;     ///< to the latest frame, by the weather's clock
  bool is_season;

  SnowCoverPart(const Scene& scene);
};

/// Of the clouds.
struct CloudsPart {
  std::uint64_t seed;
  const std::vector<CloudLayer>& layers;
  const std::vector<CloudEvent>& events;
  const Season& season;  ///< without a first day where the scene is no season
  const Sun& sun;
  double turbidity;
  double frame_seconds;  ///< of [film]
  double season_s;       ///< calendar.h's cloud_season_s()

  CloudsPart(const Scene& scene);
};

}  // namespace wold::scene
