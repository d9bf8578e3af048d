#pragma once

#include <filesystem>

#include "meadow/frame_grass.h"
#include "phenology/film_season.h"
#include "place/mixture_field.h"
#include "place/site.h"
#include "place/withering.h"
#include "scene/scene.h"
#include "snow/weather.h"

/// What a film makes once and passes on, for tests that need a part of it alone.
namespace wold::test {

/// A scene as the film of its season, if it is one.
inline scene::Scene film_of(const scene::Scene& scene) {
  return phenology::as_film(scene, phenology::film_season(scene).get());
}

inline place::Site site_of(const scene::Scene& scene,
                           const std::filesystem::path& snow_folder = {}) {
  return place::make_site(scene, phenology::film_season(scene), snow_folder);
}

inline place::Withering withering_of(const scene::Scene& scene, const Heightfield& terrain) {
  return {scene, terrain, phenology::film_season(scene)};
}

inline place::MixtureField mixtures_of(const scene::Scene& scene, const Heightfield& terrain) {
  return {scene, terrain};
}

inline meadow::FrameGrass grass_of(const scene::Scene& scene, int frame) {
  const auto season = phenology::film_season(scene);
  return meadow::still_grass(scene, season.get(), snow::Weather(scene, season.get()), frame);
}

}  // namespace wold::test
