#include "cloud/timeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "phenology/film_season.h"

namespace wold::cloud {
namespace {

using scene::CloudEventKind;

scene::Scene one_layer(std::vector<scene::CloudEvent> events) {
  scene::Scene scene;
  scene.clouds.resize(1);
  scene.clouds[0].speed_m_s = 8.0;
  scene.clouds[0].heading_deg = 90.0;
  scene.cloud_events = std::move(events);
  return scene;
}

TEST(Drift, GoesWhereTheHeadingPointsToInMetresPerSecond) {
  scene::Scene scene = one_layer({});
  EXPECT_NEAR(glm::distance(Timeline(scene, 0, 1e3).at(100.0).way_m, {800.0, 0.0}), 0.0, 1e-9);
  scene.clouds[0].heading_deg = 0.0;
  EXPECT_NEAR(glm::distance(Timeline(scene, 0, 1e3).at(100.0).way_m, {0.0, 800.0}), 0.0, 1e-9);
}

TEST(Drift, IsTheIntegralOfItsVelocity) {
  scene::Scene scene =
      one_layer({{.kind = CloudEventKind::wind,
                  .start_s = 50,
                  .duration_s = 40,
                  .heading_deg = 350,
                  .speed_m_s = 20},
                 {.kind = CloudEventKind::slower, .start_s = 120, .duration_s = 10, .factor = 4},
                 {.kind = CloudEventKind::faster, .start_s = 130, .duration_s = 30, .factor = 2}});
  scene.clouds[0].gusts_m_s = 3.0;
  const Timeline timeline(scene, 0, 1e3);
  const int steps = 20000;  // the midpoint rule's error falls with their square
  const double step_s = 200.0 / steps;
  glm::dvec2 way(0.0);
  for (int i = 0; i < steps; ++i) {
    way += step_s * timeline.at((i + 0.5) * step_s).velocity_m_s;
    if (i % 1000 != 999) continue;
    EXPECT_NEAR(glm::distance(timeline.at((i + 1) * step_s).way_m, way), 0.0, 1e-3) << i;
  }
}

TEST(Drift, TurnsTheShorterWayAndEndsAsTheWindSays) {
  const Timeline timeline(one_layer({{.kind = CloudEventKind::wind,
                                      .start_s = 10,
                                      .duration_s = 20,
                                      .heading_deg = 350,
                                      .speed_m_s = 5}}),
                          0, 1e3);
  const double deg = std::numbers::pi / 180.0;
  const glm::dvec2 end = timeline.at(31.0).velocity_m_s;
  EXPECT_NEAR(glm::distance(end, 5.0 * glm::dvec2(std::sin(350 * deg), std::cos(350 * deg))), 0.0,
              1e-12);
  // From 90 to -10 degrees through north-east, at 6.5 m/s half-way.
  const glm::dvec2 middle = timeline.at(20.0).velocity_m_s;
  EXPECT_NEAR(glm::distance(middle, 6.5 * glm::dvec2(std::sin(40 * deg), std::cos(40 * deg))), 0.0,
              1e-12);
}

/// Thirty days, one a frame of 4 s, in which the wind turns by half a turn and grows three times as
/// fast.
scene::Scene windy_season() {
  scene::Scene scene = one_layer({});
  scene.season.first = {2026, 9, 1};
  scene.season.last = {2026, 10, 1};
  scene.season.frames = 31;
  scene.film.frame_seconds = 4.0;
  scene.wind.speed_m_s = 2.0;
  scene.wind.heading_deg = 10.0;
  scene.season_keys = {{.date = {2026, 9, 1}, .wind_speed_m_s = 2.0, .wind_heading_deg = 10.0},
                       {.date = {2026, 9, 21}, .wind_speed_m_s = 6.0, .wind_heading_deg = 180.0}};
  return scene;
}

// Clouds turn with the season's wind, their own events besides.
TEST(Drift, FollowsTheSeasonsWind) {
  scene::Scene scene = windy_season();
  const auto season = phenology::film_season(scene);
  const double deg = std::numbers::pi / 180.0;
  const glm::dvec2 end = Timeline(scene, 0, 1e3, season.get()).at(100.0).velocity_m_s;
  EXPECT_NEAR(glm::distance(end, 24.0 * glm::dvec2(std::sin(260 * deg), std::cos(260 * deg))), 0.0,
              1e-9);
  scene.cloud_events = {
      {.kind = CloudEventKind::faster, .start_s = 30, .duration_s = 50, .factor = 2}};
  const Timeline timeline(scene, 0, 1e3, season.get());
  EXPECT_NEAR(glm::length(timeline.at(100.0).velocity_m_s), 48.0, 1e-9);
  EXPECT_NEAR(glm::distance(timeline.at(0.0).velocity_m_s, {8.0, 0.0}), 0.0, 1e-12);
  const int steps = 30000;
  const double step_s = 150.0 / steps;  // and beyond the film
  glm::dvec2 way(0.0);
  for (int i = 0; i < steps; ++i) way += step_s * timeline.at((i + 0.5) * step_s).velocity_m_s;
  EXPECT_NEAR(glm::distance(timeline.at(150.0).way_m, way), 0.0, 1e-3);
}

TEST(Drift, HardlyTurningIsAsExactAsTurning) {
  const auto way = [](double turn_rad) {
    return way_m({0.0, 10.0, 4.0, 9.0, 0.3, 0.3 + turn_rad}, 10.0);
  };
  const double below = 0.999e-3, above = 1.001e-3;  // either side of where the series takes over
  const glm::dvec2 slope = (way(above) - way(below)) / (above - below);
  const glm::dvec2 slope_near = (way(below) - way(0.0)) / below;
  EXPECT_NEAR(glm::distance(slope, slope_near), 0.0, 0.05);
  EXPECT_NEAR(glm::distance(way(0.0), 65.0 * glm::dvec2(std::sin(0.3), std::cos(0.3))), 0.0, 1e-10);
}

TEST(Gusts, HaveTheirDeviationAndNoMean) {
  glm::dvec2 sum(0.0), squares(0.0);
  const int samples = 40000;
  for (int i = 0; i < samples; ++i) {
    const glm::dvec2 velocity = gust_velocity_m_s(2.0, i * 7.3, 4);
    sum += velocity;
    squares += velocity * velocity;
  }
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(sum[axis] / samples, 0.0, 0.02);
    EXPECT_NEAR(std::sqrt(squares[axis] / samples), 2.0, 0.02);
  }
  EXPECT_EQ(gust_way_m(2.0, 0.0, 4), glm::dvec2(0.0));
}

TEST(PaperDrift, GrowsByATenThousandthAndBySine) {
  scene::Scene scene =
      one_layer({{.kind = CloudEventKind::faster, .start_s = 100, .duration_s = 50},
                 {.kind = CloudEventKind::wind, .start_s = 200, .duration_s = 10}});
  scene.clouds[0].motion = scene::Law::paper;
  scene.film.frame_seconds = 10.0;
  const Timeline timeline(scene, 0, 500.0);
  const auto cells = [&](double time_s) { return timeline.at(time_s).way_m / 500.0; };
  const double start = cells(0.0).x;
  EXPECT_GE(start, 0.0);
  EXPECT_LT(start, 1.0);
  EXPECT_NEAR(cells(100.0).x - start, 10 * 0.0001, 1e-12);
  EXPECT_NEAR(cells(150.0).x - start, 15 * 0.0001 + 5 * 0.01, 1e-12);
  EXPECT_NEAR(cells(200.0).x - cells(150.0).x, 5 * 0.0001, 1e-12);
  EXPECT_NEAR(cells(300.0).x - cells(200.0).x, -10 * 0.0001, 1e-12);  // the wind is against it
  EXPECT_NEAR(cells(123.0).y, std::sin(cells(123.0).x), 1e-12);
}

TEST(Timeline, GathersAndDissipatesMonotonically) {
  scene::Scene scene =
      one_layer({{.kind = CloudEventKind::gather, .start_s = 10, .duration_s = 10, .fraction = 0.5},
                 {.kind = CloudEventKind::dissipate,
                  .start_s = 30,
                  .duration_s = 20,
                  .fade = scene::CloudFade::paper}});
  scene.clouds[0].gathered = 0.2;
  const Timeline timeline(scene, 0, 1e3);
  EXPECT_DOUBLE_EQ(timeline.at(0.0).amount, 0.2);
  EXPECT_DOUBLE_EQ(timeline.at(15.0).amount, 0.4);
  EXPECT_DOUBLE_EQ(timeline.at(25.0).amount, 0.6);
  EXPECT_FALSE(timeline.at(25.0).amount_is_alpha);
  EXPECT_DOUBLE_EQ(timeline.at(40.0).amount, 0.3);
  EXPECT_TRUE(timeline.at(40.0).amount_is_alpha);
  EXPECT_DOUBLE_EQ(timeline.at(1e6).amount, 0.0);
  for (int i = 0; i < 100; ++i) {
    EXPECT_LE(timeline.at(10.0 + i * 0.1).amount, timeline.at(10.1 + i * 0.1).amount);
    EXPECT_GE(timeline.at(30.0 + i * 0.2).amount, timeline.at(30.2 + i * 0.2).amount);
  }
}

/// A frame of 4 s every second day of 40: the clouds' clock has 84 s at the end.
TEST(Timeline, DaysOfASeasonAreOnTheCloudsClock) {
  scene::Scene scene =
      one_layer({{.kind = CloudEventKind::dissipate,
                  .date = {2026, 9, 11},
                  .until = {2026, 9, 21},
                  .fraction = 0.5},
                 {.kind = CloudEventKind::gather, .duration_s = 8.0, .date = {2026, 10, 1}}});
  scene.season.first = {2026, 9, 1};
  scene.season.last = {2026, 10, 11};
  scene.season.frames = 21;
  scene.season_keys = {{.date = {2026, 9, 1}, .weathering = 0.0}};
  scene.film.frame_seconds = 4.2;
  const Timeline timeline(scene, 0, 1e3);
  const auto amount_on_day = [&](double day) { return timeline.at(2.1 * day).amount; };
  EXPECT_EQ(amount_on_day(9.0), 1.0);
  EXPECT_NEAR(amount_on_day(15.0), 0.75, 1e-12);
  EXPECT_NEAR(amount_on_day(25.0), 0.5, 1e-12);
  EXPECT_NEAR(timeline.at(2.1 * 30.0 + 4.0).amount, 0.75, 1e-12);
}

TEST(Timeline, TurnsFromShapeToShape) {
  const Timeline timeline(
      one_layer({{.kind = CloudEventKind::wind, .start_s = 10, .duration_s = 10, .heading_deg = 0},
                 {.kind = CloudEventKind::wind, .start_s = 20, .duration_s = 10, .shear = 0},
                 {.kind = CloudEventKind::wind,
                  .start_s = 40,
                  .duration_s = 10,
                  .fade = scene::CloudFade::paper}}),
      0, 1e3);
  ASSERT_EQ(timeline.shapes().size(), 3u);  // a wind without shear makes none
  EXPECT_EQ(timeline.at(5.0).next_fraction, 0.0);
  EXPECT_EQ(timeline.at(15.0).shape, 0u);
  EXPECT_EQ(timeline.at(15.0).next_shape, 1u);
  EXPECT_DOUBLE_EQ(timeline.at(15.0).next_fraction, 0.5);
  EXPECT_DOUBLE_EQ(timeline.at(35.0).next_fraction, 1.0);
  EXPECT_EQ(timeline.at(45.0).shape, 1u);
  EXPECT_TRUE(timeline.at(45.0).shapes_by_alpha);
}

TEST(Timeline, LightTurnsToTheColourOrToTheSuns) {
  const Timeline timeline(
      one_layer({{.kind = CloudEventKind::light, .start_s = 0, .duration_s = 10},
                 {.kind = CloudEventKind::light,
                  .start_s = 20,
                  .duration_s = 10,
                  .colour = {},
                  .sun_elevation_deg = 8.0}}),
      0, 1e3);
  EXPECT_NEAR(glm::distance(timeline.at(5.0).light, {0.85, 0.7, 0.7}), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(timeline.at(15.0).light, {0.7, 0.4, 0.4}), 0.0, 1e-12);
  const glm::dvec3 low = timeline.at(100.0).light;
  EXPECT_EQ(low.r, 1.0);
  EXPECT_GT(low.r, low.g);
  EXPECT_GT(low.g, low.b);
  EXPECT_NEAR(glm::distance(sunlight_colour(90.0, 3.0), glm::dvec3(1.0)), 0.0, 1e-12);
}

TEST(Timeline, EventsOfOtherLayersDoNotCount) {
  scene::Scene scene =
      one_layer({{.kind = CloudEventKind::dissipate, .layer = 2, .duration_s = 1.0}});
  scene.clouds.resize(2);
  EXPECT_EQ(Timeline(scene, 0, 1e3).at(10.0).amount, 1.0);
  EXPECT_EQ(Timeline(scene, 1, 1e3).at(10.0).amount, 0.0);
}

}  // namespace
}  // namespace wold::cloud
