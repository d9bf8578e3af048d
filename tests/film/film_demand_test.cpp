#include "film/film_demand.h"

#include <gtest/gtest.h>

namespace wold::film {
namespace {

// By the second frame it has snowed for an hour.
TEST(FilmDemand, SaysWhetherSnowHasFallen) {
  Request request;
  scene::Scene& scene = request.scene;
  scene.terrain.samples = 33;
  scene.grass.key_frames = {0.0, 1.0};
  scene.growth.cover = 0.0;
  scene.ageing.frames = {0.0, 0.0};
  scene.film.frame_seconds = 3600.0;
  scene.weather.temperature_c = -3.0;
  scene.weather.precipitation_mm_h = 2.0;
  request.frames = {1, 2};
  const FilmDemand snows(request, place::growing_ground(request.scene));
  EXPECT_FALSE(snows.at(1).has_snow);
  EXPECT_TRUE(snows.at(2).has_snow);
  scene.weather.temperature_c = 8.0;
  EXPECT_FALSE(FilmDemand(request, place::growing_ground(request.scene)).at(2).has_snow);
}

}  // namespace
}  // namespace wold::film
