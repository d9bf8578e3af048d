#include "meadow/wind_lean.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "grass/texel/fibres.h"
#include "meadow/cells.h"
#include "meadow/lean_light.h"
#include "support/film_parts.h"

namespace wold::meadow {
namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

/// Leans of the grass at places farther apart than the waves are long.
std::vector<glm::dvec2> leans(const scene::Scene& scene) {
  const WindLean wind_lean(scene.wind, {}, scene.seed);
  std::vector<glm::dvec2> result;
  for (int j = 0; j < 60; ++j)
    for (int i = 0; i < 60; ++i)
      result.push_back(wind_lean.lean(glm::dvec2(i, j) * (1.37 * scene.wind.wave_length_m)));
  return result;
}

TEST(WindLean, LeansWithTheWindAsMuchAsAsked) {
  scene::Scene scene;
  scene.wind = {.heading_deg = 90.0, .lean_deg = 12.0, .waves_deg = 5.0, .wave_length_m = 4.0};
  double sum_deg = 0.0;
  double squares = 0.0;
  glm::dvec2 sum(0.0);
  const std::vector<glm::dvec2> all = leans(scene);
  for (const glm::dvec2& lean : all) {
    const double along = lean.x < 0.0 ? -glm::length(lean) : glm::length(lean);
    const double lean_deg = std::atan(along) * degrees_per_radian;
    sum_deg += lean_deg;
    squares += (lean_deg - 12.0) * (lean_deg - 12.0);
    sum += lean;
  }
  const auto count = static_cast<double>(all.size());
  EXPECT_NEAR(sum_deg / count, 12.0, 0.4);
  EXPECT_NEAR(std::sqrt(squares / count), 5.0, 0.5);
  EXPECT_NEAR(std::atan2(sum.y, sum.x), 0.0, 2.0 / degrees_per_radian);  // to the east
}

TEST(WindLean, NeighboursLeanNearlyAlikeAndStillAirCombsNothing) {
  scene::Scene scene;
  const WindLean wind_lean(scene.wind, {}, scene.seed);
  const glm::dvec2 step(scene.grass.patch_m, 0.0);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 at_m(0.173 * i, 0.31 * i);
    EXPECT_LT(glm::distance(wind_lean.lean(at_m), wind_lean.lean(at_m + step)), 0.2);
  }
  scene.wind.lean_deg = scene.wind.waves_deg = 0.0;
  EXPECT_EQ(WindLean(scene.wind, {}, scene.seed).lean({3.3, 4.4}), glm::dvec2(0.0));
}

// In a season the mean lean follows the wind of the week before, and waves stay where they are.
TEST(WindLean, FollowsTheSeasonsWind) {
  scene::Scene scene;
  scene.wind.heading_deg = 90.0;
  scene.wind.speed_m_s = 2.0;
  scene.wind.lean_deg = 12.0;
  scene.wind.waves_deg = 3.0;
  scene.season.first = {2026, 9, 1};
  scene.season.last = {2026, 10, 1};
  scene.season.frames = 31;
  scene.season_keys = {{.date = {2026, 9, 11}, .wind_speed_m_s = 2.0, .wind_heading_deg = 90.0},
                       {.date = {2026, 9, 12}, .wind_speed_m_s = 3.0, .wind_heading_deg = 180.0}};
  const scene::Scene film = test::film_of(scene);
  const WindLean before = test::grass_of(film, 11).wind_lean;
  const WindLean after = test::grass_of(film, 21).wind_lean;
  for (int i = 0; i < 100; ++i) {
    const glm::dvec2 at_m(0.73 * i, 0.31 * i);
    const glm::dvec2 first = before.lean(at_m), last = after.lean(at_m);
    EXPECT_NEAR(glm::dot(first, last), 0.0, 1e-9);
    EXPECT_NEAR(std::atan(glm::length(last)), 1.5 * std::atan(glm::length(first)), 1e-9);
  }
}

TEST(WindLean, TipsMoveAlongTheGround) {
  Heightfield slope(2, 6.0);
  slope.at(1, 0) = slope.at(1, 1) = 3.0F;  // z = x / 2
  const glm::dvec2 lean(0.2, -0.1);
  const glm::dmat4 matrix =
      landscape::fit_to_ground(slope, 0.6, {{4, 5}, /*turn=*/1, lean}, {}).world_from_cell;
  EXPECT_NEAR(glm::determinant(matrix), 1.0, 1e-12);
  const glm::dvec3 up(matrix[2]);
  EXPECT_EQ(glm::dvec2(up), lean);
  EXPECT_NEAR(up.z, 1.0 + 0.5 * lean.x, 1e-6);
}

/// One upright fibre without gloss under a sun at 45 degrees in the south.
grass::Lighting lighting() {
  grass::Lighting light;
  light.sun_direction = glm::normalize(glm::dvec3(0.0, -1.0, 1.0));
  light.sun_irradiance = glm::vec3(0.8F);
  light.sky_radiance.assign(grass::sky_size(), glm::vec3(0.1F));
  light.eye_direction = {0.0, -1.0, 0.0};
  return light;
}

TEST(LeanLight, UprightGrassForTheBakedEyeStaysAsItIs) {
  const LeanLight light({{glm::vec3(0, 0, 1), glm::vec3(0.3F), glm::vec3(0.1F), 0.2F}}, lighting(),
                        24.0F);
  EXPECT_LT(glm::distance(light.factor(glm::dvec2(0.0), lighting().eye_direction), glm::vec3(1.0F)),
            1e-5F);
}

// What is left is the light that others scatter.
TEST(LeanLight, AFibreAlongTheSunsRaysGetsNoneOfThem) {
  grass::Lighting sun_alone = lighting();
  for (glm::vec3& radiance : sun_alone.sky_radiance) radiance = glm::vec3(0.0F);
  const LeanLight light({{glm::vec3(0, 0, 1), glm::vec3(0.3F), glm::vec3(0.0F), 0.0F}}, sun_alone,
                        24.0F);
  const auto leaning = [&](double north) {
    return light.factor({0.0, north}, sun_alone.eye_direction).g;
  };
  EXPECT_LT(leaning(-1.0), 0.15F);
  EXPECT_GT(leaning(1.0), 1.0F);  // across the rays
}

TEST(LeanLight, GlintsWhereItMirrorsTheSun) {
  const LeanLight light({{glm::vec3(0, 0, 1), glm::vec3(0.3F), glm::vec3(0.1F), 0.5F}}, lighting(),
                        24.0F);
  // An upright fibre mirrors a sun at 45 degrees to a cone 45 degrees below the horizontal.
  const glm::dvec3 mirrored = glm::normalize(glm::dvec3(0.0, 1.0, -1.0));
  EXPECT_GT(light.factor(glm::dvec2(0.0), mirrored).g,
            1.2F * light.factor(glm::dvec2(0.0), lighting().eye_direction).g);
}

// Upright fibres under a sun at 45 degrees, seen from the same height: G is the same to both, so
// half of what is seen is sunlit. Fibres along the sun's rays hide nothing from it.
TEST(LeanLight, TheSunShinesInMoreDeeplyWhereBladesLeanToIt) {
  const LeanLight light({{glm::vec3(0, 0, 1), glm::vec3(0.3F), glm::vec3(0.0F), 0.0F}}, lighting(),
                        24.0F);
  const glm::dvec3 from_north = glm::normalize(glm::dvec3(0.0, 1.0, 1.0));
  EXPECT_NEAR(light.sunlit_share({0.0, 0.0}, {0.0, 0.0}, from_north), 0.5, 1e-6);
  EXPECT_NEAR(light.sunlit_share({0.0, -1.0}, {0.0, -1.0}, from_north), 1.0, 1e-3);
  EXPECT_LT(light.sunlit_share({0.0, 0.5}, {0.0, 0.5}, from_north), 0.4);
  const glm::dvec2 upright(0.0), to_sun(0.0, -0.3);
  EXPECT_EQ(light.factor(to_sun, to_sun, from_north), light.factor(to_sun, from_north));
  EXPECT_GT(light.factor(to_sun, upright, from_north).g, light.factor(to_sun, from_north).g);
}

// A thin blade bends about its broad side: where the wind alone has bent it that side lies up the
// wind, square to the blade; of one that droops to the side as far, half.
TEST(TurnedBlade, ShowsItsBroadSideToTheWind) {
  grass::Fibre tip{{0, 0, 1}, glm::vec3(0.3F), glm::vec3(0.1F), 0.2F};
  tip.along = 1.0F;
  const glm::vec2 gust(std::tan(0.3F), 0.0F), none(0.0F);
  const TurnedBlade east = turned_by_wind(tip, none, gust);
  EXPECT_FLOAT_EQ(east.turned, 1.0F);
  EXPECT_NEAR(glm::dot(east.fibre.tangent, glm::vec3(std::sin(0.4F), 0.0F, std::cos(0.4F))), 1.0F,
              1e-5F);
  EXPECT_NEAR(std::abs(glm::dot(east.normal, glm::vec3(std::cos(0.4F), 0.0F, -std::sin(0.4F)))),
              1.0F, 1e-5F);
  grass::Fibre drooping = tip;
  drooping.tangent = {0.0F, std::sin(0.4F), std::cos(0.4F)};
  const TurnedBlade half = turned_by_wind(drooping, none, gust);
  EXPECT_NEAR(half.turned, 0.5F, 1e-4F);
  EXPECT_NEAR(glm::dot(half.normal, half.fibre.tangent), 0.0F, 1e-5F);
  EXPECT_NEAR(glm::length(half.normal), 1.0F, 1e-5F);
  EXPECT_EQ(turned_by_wind(drooping, {0.2F, 0.1F}, {0.2F, 0.1F}).turned, 0.0F);
}

// Wind lifts what droops against it, which a shear would not.
TEST(TurnedBlade, DroopingTipsTurnWithTheWind) {
  const grass::Fibre level{{-1, 0, 0}, glm::vec3(0.3F), glm::vec3(0.1F), 0.2F, 1.0F};
  const TurnedBlade lifted = turned_by_wind(level, {0.0F, 0.0F}, {std::tan(0.3F), 0.0F});
  EXPECT_NEAR(lifted.fibre.tangent.z, std::sin(0.4F), 1e-5F);
  const grass::Fibre foot{{-1, 0, 0}, glm::vec3(0.3F), glm::vec3(0.1F), 0.2F, 0.0F};
  EXPECT_EQ(turned_by_wind(foot, {0.0F, 0.0F}, {1.0F, 0.0F}).fibre.tangent, foot.tangent);
}

/// Grass that stands every way.
std::vector<grass::Fibre> nearly_upright() {
  std::vector<grass::Fibre> fibres;
  for (int i = 0; i < 12; ++i) {
    const float azimuth = glm::radians(30.0F * static_cast<float>(i));
    fibres.push_back(
        {glm::normalize(glm::vec3(0.3F * std::cos(azimuth), 0.3F * std::sin(azimuth), 1.0F)),
         glm::vec3(0.4F), glm::vec3(0.2F), 0.1F});
  }
  return fibres;
}

// With sun and eye in the south, a gust to the north turns broad sides to both, one to the east
// their edges: brighter and darker than blades that lean as far but face any way.
TEST(LeanLight, GustsShowBroadSidesOrEdges) {
  const LeanLight light(nearly_upright(), lighting(), 24.0F);
  const glm::dvec3 eye = glm::normalize(glm::dvec3(0.0, -1.0, 0.4));
  const glm::dvec2 none(0.0), away(0.0, 0.6), aside(0.6, 0.0);
  EXPECT_GT(light.factor(away, none, eye).g, 1.05F * light.factor(away, eye).g);
  EXPECT_LT(light.factor(aside, none, eye).g, 0.9F * light.factor(aside, eye).g);
  EXPECT_GT(light.factor(away, none, eye).g, 1.25F * light.factor(none, eye).g);
}

// Of two halves of blades that a gust turns to the sun and away from it, the eye sees the upper
// ones: they hide the others, the more the flatter it looks.
TEST(LeanLight, OfACanopyTipsAreSeen) {
  std::vector<grass::Fibre> fibres = nearly_upright();
  for (std::size_t i = 0; i < fibres.size(); ++i) fibres[i].along = i % 2 == 0 ? 0.9F : 0.05F;
  std::vector<grass::Fibre> tips;
  for (std::size_t i = 0; i < fibres.size(); i += 2) tips.push_back(fibres[i]);
  const glm::dvec2 none(0.0), away(0.0, 0.5);
  const auto gain = [&](const std::vector<grass::Fibre>& blades, double height) {
    const LeanLight light(blades, lighting(), 24.0F);
    const glm::dvec3 eye = glm::normalize(glm::dvec3(0.0, -1.0, height));
    return light.factor(away, none, eye).g / light.factor(none, eye).g - 1.0F;
  };
  EXPECT_GT(gain(fibres, 0.1), 0.85F * gain(tips, 0.1));
  EXPECT_LT(gain(fibres, 1.5), 0.9F * gain(tips, 1.5));
}

// A gust that is just beginning changes nothing at once.
TEST(LeanLight, IsSmoothInTheLean) {
  const LeanLight light(nearly_upright(), lighting(), 24.0F);
  const glm::dvec3 eye = glm::normalize(glm::dvec3(0.5, -1.0, 0.4));
  const glm::dvec2 combed(0.1, 0.05);
  float before = light.factor(combed, eye).g;
  for (int i = 0; i <= 100; ++i) {
    const float now = light.factor(combed + glm::dvec2(0.008 * i, 0.004 * i), combed, eye).g;
    EXPECT_NEAR(now / before, 1.0F, 0.02F) << i;
    before = now;
  }
}

TEST(RepresentativeFibres, StandForTheWholePatch) {
  const scene::Scene scene;
  const grass::MeadowModel model(scene);
  const grass::BladePatch patch = grass::WitheringPatch(scene, model, 0).at(0.4);
  const auto mean = [](const std::vector<grass::Fibre>& fibres) {
    glm::vec3 sum(0.0F);
    for (const grass::Fibre& fibre : fibres) sum += fibre.albedo;
    return sum / static_cast<float>(fibres.size());
  };
  const auto some = grass::representative_fibres(patch, model, 150);
  EXPECT_NEAR(static_cast<double>(some.size()), 150.0, 30.0);
  const glm::vec3 apart = mean(some) / grass::mean_albedo(patch, model) - 1.0F;
  EXPECT_LT(glm::length(apart), 0.15F);
}

}  // namespace
}  // namespace wold::meadow
