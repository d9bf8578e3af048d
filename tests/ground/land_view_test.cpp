#include "ground/land_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/parallel.h"
#include "ground/land_appearance.h"

namespace wold::ground {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
/// The earth's radius, larger by how much air bends light.
constexpr double seen_radius_m = 6.371e6 / (1.0 - 0.13);

scene::Terrain level() {
  scene::Terrain terrain;
  terrain.size_m = 100.0;
  terrain.samples = 17;
  return terrain;
}

/// Level land, out to a distance, seen from the middle of its square.
struct LevelLand {
  explicit LevelLand(double eye_m, double reach_m, double own_height_m = 0.0)
      : ground(17, 100.0),
        land(level(), Heightfield(17, 100.0), 1, reach_m),
        view(land, with_wall(own_height_m), {50.0, 50.0, eye_m},
             {.middle_rad = 0.0, .half_rad = 20.0 * degree, .step_rad = 0.1 * degree}) {}

  /// The square with a wall of that height in the north.
  Heightfield& with_wall(double height_m) {
    for (int i = 0; i < 17; ++i) ground.at(i, 12) = static_cast<float>(height_m);
    return ground;
  }

  Heightfield ground;
  terrain::Surroundings land;
  LandView view;
};

glm::dvec3 northward(double rise, double azimuth_deg = 0.0) {
  return {std::sin(azimuth_deg * degree), std::cos(azimuth_deg * degree), rise};
}

// An eye that high over level land sees it where the line of sight meets it.
TEST(LandView, FindsThePlaceInADirection) {
  const LevelLand level(20.0, 40000.0);
  for (const double distance_m : {60.0, 300.0, 2000.0}) {
    const double rise = -20.0 / distance_m - distance_m / (2.0 * seen_radius_m);
    const auto place = level.view.place(northward(rise, 7.0));
    ASSERT_TRUE(place);
    const glm::dvec2 way = *place - glm::dvec2(50.0);
    EXPECT_NEAR(glm::length(way), distance_m, 0.02 * distance_m);
    EXPECT_NEAR(std::atan2(way.x, way.y), 7.0 * degree, 1e-6);
  }
  EXPECT_FALSE(level.view.place(northward(0.01)));
}

// Between its width, 0.2 degrees there, and ten times of that.
TEST(LandView, KnowsWhatAPixelCovers) {
  const LevelLand level(20.0, 40000.0);
  const double width_m = 300.0 * 0.2 * degree;
  EXPECT_NEAR(level.view.covered_m({50.0, 350.0}), std::sqrt(10.0) * width_m, 0.01 * width_m);
}

// The horizon's dip: sqrt(2 h / R), of a radius larger by refraction.
TEST(LandView, SeesARoundEarth) {
  for (const double eye_m : {20.0, 200.0}) {
    const LevelLand level(eye_m, 100000.0);
    const double dip = std::sqrt(2.0 * eye_m / seen_radius_m);
    EXPECT_FALSE(level.view.place(northward(-0.97 * dip)));
    EXPECT_TRUE(level.view.place(northward(-1.03 * dip)));
  }
}

TEST(LandView, IsHiddenBehindTheSquaresOwnGround) {
  EXPECT_EQ(LevelLand(20.0, 40000.0, 30.0).view.place(northward(-0.1)), std::nullopt);
  EXPECT_NE(LevelLand(20.0, 40000.0, 0.0).view.place(northward(-0.1)), std::nullopt);
}

TEST(SeesLandAround, WhereNoOwnGroundStandsBeforeIt) {
  LevelLand open(20.0, 40000.0), walled(20.0, 40000.0, 60.0);
  landscape::Camera camera{{50.0, 50.0, 20.0}, {50.0, 90.0, 20.0}, 40.0};
  EXPECT_TRUE(sees_land_around(open.land, open.ground, camera, 320, 180));
  EXPECT_FALSE(sees_land_around(walled.land, walled.ground, camera, 320, 180));
  camera.target_m = {50.0, 60.0, 0.0};  // down before its feet
  EXPECT_FALSE(sees_land_around(open.land, open.ground, camera, 320, 180));
}

// The border of level ground lies 0.4 below the eye per metre. A picture 2.8 degrees high to each
// side sees beyond it just when its middle is less than that farther down.
// Where it does not, nobody looks at the land: no loop runs that could be stopped.
TEST(SeesLandAround, WhereThePictureReachesAboveTheSkyline) {
  LevelLand open(20.0, 40000.0);
  const double skyline = std::atan(-0.4);
  const double half_height = std::atan(std::tan(5.0 * degree) * 9.0 / 16.0);
  for (const double above : {-3.0 * degree, 1.0 * degree}) {
    const double pitch = skyline - half_height + above;
    const landscape::Camera camera{
        {50.0, 50.0, 20.0}, {50.0, 60.0, 20.0 + 10.0 * std::tan(pitch)}, 10.0};
    const auto look = [&] { return sees_land_around(open.land, open.ground, camera, 320, 180); };
    EXPECT_EQ(look(), above > 0.0) << above;
    const StopScope no_loops([] { throw InterruptedError(); });
    if (above > 0.0)
      EXPECT_THROW(look(), InterruptedError);
    else
      EXPECT_NO_THROW(look());
  }
}

TEST(Panorama, HasAllThatTheCameraSees) {
  const landscape::Camera ahead{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 60.0};
  EXPECT_NEAR(panorama(ahead, 320, 180).middle_rad, 90.0 * degree, 1e-9);
  EXPECT_NEAR(panorama(ahead, 320, 180).half_rad, std::atan(1.1 * std::tan(30.0 * degree)), 1e-6);
  const landscape::Camera down{{0.0, 0.0, 0.0}, {1e-3, 0.0, -1.0}, 60.0};
  EXPECT_EQ(panorama(down, 320, 180).half_rad, std::numbers::pi);
}

// Snow above 500 m, rock where it is steep, a meadow elsewhere: what lies alike looks alike.
TEST(LandAppearance, IsThatOfWhatLiesAlike) {
  const glm::vec3 snow(0.28F), rock(0.06F), meadow(0.02F, 0.04F, 0.01F);
  std::vector<LandSample> samples;
  for (int height_m = 0; height_m <= 1000; height_m += 25)
    for (int slope_deg = 0; slope_deg <= 50; slope_deg += 2) {
      const double rad = slope_deg * degree;
      const glm::dvec3 up(std::sin(rad), 0.0, std::cos(rad));
      samples.push_back({up, 1.0 * height_m,
                         height_m > 500   ? snow
                         : slope_deg > 30 ? rock
                                          : meadow});
    }
  const LandAppearance look(samples);
  const auto tilted = [](double slope_deg) {
    return glm::dvec3(std::sin(slope_deg * degree), 0.0, std::cos(slope_deg * degree));
  };
  EXPECT_NEAR(look.at(tilted(5.0), 900.0).g, snow.g, 0.01);
  EXPECT_NEAR(look.at(tilted(45.0), 100.0).r, rock.r, 0.01);
  EXPECT_NEAR(look.at(tilted(5.0), 100.0).g, meadow.g, 0.005);
  EXPECT_NEAR(look.at(tilted(5.0), 5000.0).g, snow.g, 0.01);   // higher than all that is known
  EXPECT_NEAR(look.at(tilted(80.0), -900.0).r, rock.r, 0.01);  // steeper and lower
}

}  // namespace
}  // namespace wold::ground
