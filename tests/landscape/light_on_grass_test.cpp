#include "landscape/light_on_grass.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>

namespace wold::landscape {
namespace {

/// Light of 1 on 100 m, of 2 and of 3 on smaller squares, on patches of 1 m; what stands rises
/// eastward from nothing to all.
Landscape nested() {
  Landscape landscape;
  landscape.patch_m = 1.0;
  landscape.light = ColourMap(11, 100.0, glm::vec3(1.0F));
  landscape.light_details = {ColourMap(21, {glm::dvec2(20.0), 40.0}, glm::vec3(2.0F)),
                             ColourMap(31, {glm::dvec2(30.0, 35.0), 10.0}, glm::vec3(3.0F))};
  landscape.extinction_factor = FactorMap(101, 100.0);
  for (int j = 0; j <= 100; ++j)
    for (int i = 0; i <= 100; ++i)
      landscape.extinction_factor.at(i, j) = static_cast<float>(i) / 100.0F;
  return landscape;
}

TEST(LightOnGrass, IsThatOfTheFinestMapAroundAPatch) {
  const Landscape landscape = nested();
  EXPECT_EQ(count_light_maps(landscape), 3);
  EXPECT_EQ(light_map_at(landscape, {35.0, 40.0}), 2);
  EXPECT_EQ(light_map_at(landscape, {31.0, 36.0}), 2);
  EXPECT_EQ(light_map_at(landscape, {30.9, 36.0}), 1);  // its patch is too near to the border
  EXPECT_EQ(light_map_at(landscape, {50.0, 50.0}), 1);
  EXPECT_EQ(light_map_at(landscape, {59.1, 50.0}), 0);
  EXPECT_EQ(light_map_at(landscape, {-5.0, 50.0}), 0);
  EXPECT_EQ(light_on_grass(landscape, {35.0, 40.0}), glm::vec3(3.0F));
  EXPECT_EQ(light_on_grass(landscape, {10.0, 40.0}), glm::vec3(1.0F));
  EXPECT_THROW(light_map(landscape, 3), std::out_of_range);
}

TEST(LightOnGrass, OfACellIsThatOfItsMiddle) {
  const Landscape landscape = nested();
  const glm::dmat4 cell = glm::translate(glm::dmat4(1.0), {30.5, 35.5, 7.0});
  EXPECT_EQ(light_map_of(landscape, cell), 2);
  EXPECT_EQ(light_map_of(landscape, glm::scale(cell, glm::dvec3(0.9))), 1);
}

TEST(LightOnGrass, OnWhatStandsIsTheMapTimesTheFraction) {
  const Landscape landscape = nested();
  for (int number = 0; number < 3; ++number) {
    const FactorMap fraction = standing_fraction(landscape, number);
    const ColourMap light = standing_light(landscape, number);
    EXPECT_EQ(light.samples(), fraction.samples());
    EXPECT_EQ(light.square().corner_m, light_map(landscape, number).corner_m());
    EXPECT_EQ(light.size_m(), fraction.size_m());
    EXPECT_GE(light.samples(), light_map(landscape, number).samples());
    EXPECT_NEAR(fraction.sample(33.0, 37.0), 0.33F, 1e-5F);
    EXPECT_NEAR(light.sample(33.0, 37.0).g, 0.33F * static_cast<float>(number + 1), 1e-5F);
  }
}

}  // namespace
}  // namespace wold::landscape
