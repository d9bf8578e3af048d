#include "place/starter_place.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.h"
#include "scene/parse.h"
#include "support/places.h"

/// Elevation models as people have them, in tests/data/terrain.
namespace wold::place {
namespace {

std::string model(const char* name) {
  return (wold::test::tests_folder() / "data" / "terrain" / name).string();
}

void expect_camera_inside(const scene::StarterPlace& place) {
  for (const std::array<double, 2>& at_m : {place.eye_m, place.target_m})
    for (const double metres : at_m) {
      EXPECT_GT(metres, 0.1 * place.size_m);
      EXPECT_LT(metres, 0.9 * place.size_m);
    }
  EXPECT_NE(place.eye_m, place.target_m);
}

// 36 km by 19 km at 30 m, UTM zone 11: the middle of the San Gabriel Mountains.
TEST(StarterPlace, OfBigTujungaIsTheSquareInTheMiddle) {
  const scene::StarterPlace place = starter_place(model("bigtujunga_srtm30.tif"), "hillside");
  EXPECT_EQ(place.system, "");
  EXPECT_NEAR(place.size_m, 19000.0, 500.0);
  EXPECT_NEAR(place.size_m / (place.samples - 1), 30.0, 0.5);
  ASSERT_TRUE(place.longitude_latitude_deg);
  EXPECT_NEAR(place.longitude_latitude_deg->at(0), -118.15, 0.15);
  EXPECT_NEAR(place.longitude_latitude_deg->at(1), 34.32, 0.1);
  expect_camera_inside(place);
}

// In degrees, and nothing says so.
TEST(StarterPlace, OfTheFrontRangeKnowsItsDegrees) {
  const scene::StarterPlace place = starter_place(model("front_range_srtm_gl3.asc"), "season");
  EXPECT_EQ(place.system, "EPSG:4326");
  EXPECT_NEAR(place.size_m, 13000.0, 700.0);
  EXPECT_GE(place.samples, scene::Terrain().samples);
  expect_camera_inside(place);
  const scene::Scene scene =
      scene::parse_scene(scene::starter_scene("front_range", "season", place), "front_range.toml");
  EXPECT_EQ(scene.terrain.system, "EPSG:4326");
  EXPECT_EQ(scene.camera.eye_m, place.eye_m);
  // As late in the day as the starter is in the Alps: 15 degrees are an hour.
  EXPECT_NEAR(scene.sun.longitude_deg, -105.5, 0.5);
  EXPECT_NEAR(scene.sun.time_h + scene.sun.longitude_deg / 15.0, 13.0 + 8.0 / 15.0, 0.06);
}

TEST(StarterPlace, OfLocalMetresIsSmall) {
  const scene::StarterPlace place = starter_place(model("bijou_grassland_5m.asc"), "mountain");
  EXPECT_EQ(place.system, "");
  EXPECT_NEAR(place.size_m, 400.0, 60.0);
  EXPECT_FALSE(place.longitude_latitude_deg);
  expect_camera_inside(place);
}

TEST(StarterPlace, IsRefusedWhereThereIsNone) {
  EXPECT_THROW(starter_place(model("none.tif"), "hillside"), FileError);
  EXPECT_THROW(starter_place((wold::test::tests_folder() / "CMakeLists.txt").string(), "hillside"),
               InputError);
  EXPECT_THROW(starter_place(model("bijou_grassland_5m.asc"), "hill"), InputError);
}

}  // namespace
}  // namespace wold::place
