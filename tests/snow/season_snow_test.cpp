#include <fmt/chrono.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/files.h"
#include "core/random.h"
#include "phenology/film_season.h"
#include "scene/calendar.h"
#include "snow/cover.h"
#include "snow/drifting.h"
#include "snow/large_cover.h"
#include "snowpack/snow_on_ground.h"
#include "support/temporary_folder.h"

namespace wold::snow {
namespace {

/// A winter as it could be measured: frosts and thaws of some days, dry days and wet ones.
std::string winter_days() {
  std::string table = "date,tmin_c,tmax_c,precipitation_mm,wind_speed_m_s,wind_heading_deg\n";
  const std::chrono::sys_days first(std::chrono::year(2025) / 10 / 1);
  for (std::uint64_t i = 0; i < 230; ++i) {
    const auto random = [&](const char* what) {
      return random_uniform({5, key_of("winter"), i, key_of(what)});
    };
    const double t = static_cast<double>(i);
    const double mean_c = 10.0 - 9.0 * std::sin(t * 0.0137) + 5.0 * std::sin(t * 0.4);
    const double half_k = 1.5 + 5.0 * random("range");
    const double wet_mm = random("wet") < 0.4 ? 25.0 * random("rain") : 0.0;
    table += fmt::format("{:%Y-%m-%d},{:.1f},{:.1f},{:.1f},{:.1f},{:.0f}\n",
                         first + std::chrono::days(i), mean_c - half_k, mean_c + half_k, wet_mm,
                         6.0 * random("wind"), 360.0 * random("heading"));
  }
  return table;
}

/// A film of that winter, a frame at six o'clock of each day from December to April.
class SeasonSnow : public testing::Test {
 protected:
  SeasonSnow() : folder_("season_snow") {
    const auto file = folder_.path() / "days.csv";
    write_file(file, winter_days());
    scene.season.table = file.string();
    scene.season.first = {2025, 12, 1};
    scene.season.last = {2026, 4, 30};
    scene.season.frames = frames;
    scene.sun.time_h = 6.0;
    scene.sun.latitude_deg = 46.0;
    scene = phenology::as_film(scene, phenology::film_season(scene).get());
  }

  SnowGround ground(const Heightfield& terrain) const {
    return {scene, terrain, [weather = weather()](double time_s) { return weather.at(time_s); }};
  }
  Weather weather() const { return {scene, phenology::film_season(scene).get()}; }
  double time_s(int frame) const { return scene::time_s(scene, frame); }

  static constexpr int frames = 151;
  test::TemporaryFolder folder_;
  scene::Scene scene;
};

/// A roof whose ridge runs east, so steep.
Heightfield roof(double slope, double foot_m = 0.0) {
  Heightfield terrain(65, 640.0);
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i)
      terrain.at(i, j) = static_cast<float>(foot_m + slope * (320.0 - std::abs(10.0 * j - 320.0)));
  return terrain;
}

double mean(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// But for rounding, which lets air that is at zero be a little above it.
TEST_F(SeasonSnow, OnTheLevelIsThatOfTheCurvesAtAnyHeight) {
  for (const double height_m : {0.0, 700.0}) {
    const auto season = phenology::film_season(scene);
    std::vector<weather::Day> days = season->days();
    const auto first = static_cast<std::size_t>(-season->first_day());
    for (weather::Day& day : days) {
      day.tmin_c -= lapse_k_per_m * height_m;
      day.tmax_c -= lapse_k_per_m * height_m;
    }
    const std::vector<snowpack::SnowOnGround> mornings = snowpack::snow_on_ground(days);
    const SnowGround level = ground(Heightfield(3, 20.0, static_cast<float>(height_m)));
    double deepest_m = 0.0;
    int bare = 0;
    for (int frame = 1; frame <= frames; ++frame) {
      const snowpack::SnowOnGround& expected =
          mornings[first + static_cast<std::size_t>(frame) - 1];
      const SnowGround::State state = level.at(time_s(frame));
      ASSERT_NEAR(state.water_mm.at(1, 1), expected.water_mm, 1e-5 * expected.water_mm) << frame;
      ASSERT_NEAR(state.depth_m.at(1, 1), expected.depth_m, 1e-5 * expected.depth_m) << frame;
      deepest_m = std::max(deepest_m, expected.depth_m);
      bare += expected.depth_m == 0.0;
    }
    EXPECT_GT(deepest_m, 0.3);
    EXPECT_EQ(bare > 10, height_m == 0.0);
  }
}

TEST_F(SeasonSnow, BeginsWithWhatLies) {
  scene.snow_cover.initial_mm = 50.0;
  const auto film = phenology::film_season(scene);
  const auto mornings = snowpack::snow_on_ground(film->days(), {}, 50.0);
  const SnowGround level = ground(Heightfield(2, 20.0, 0.0F));
  for (const int day : {0, 1, 3}) {
    const SnowGround::State state = level.at((film->first_day() + day) * 86400.0);
    const snowpack::SnowOnGround& expected = mornings[static_cast<std::size_t>(day)];
    EXPECT_GT(expected.depth_m, 0.0);
    EXPECT_NEAR(state.depth_m.at(0, 0), expected.depth_m, 1e-6);
    EXPECT_NEAR(state.water_mm.at(0, 0), expected.water_mm, 1e-4);
  }
}

TEST_F(SeasonSnow, IsTheSameForAFrameAloneAndInSequence) {
  scene.sun.time_h = 14.0;  // amid a step
  scene = phenology::as_film(scene, phenology::film_season(scene).get());
  const SnowGround in_sequence = ground(roof(0.8));
  for (int frame = 1; frame < 90; ++frame) in_sequence.at(time_s(frame));
  const SnowGround::State last = in_sequence.at(time_s(90));
  const SnowGround::State alone = ground(roof(0.8)).at(time_s(90));
  EXPECT_GT(mean(last.water_mm.values()), 1.0);
  EXPECT_EQ(last.depth_m.values(), alone.depth_m.values());
  EXPECT_EQ(last.water_mm.values(), alone.water_mm.values());
  EXPECT_EQ(last.albedo.values(), alone.albedo.values());
}

// In every step what falls, drifted, lies more or has left; slides keep all of it.
TEST_F(SeasonSnow, LiesOrHasLeft) {
  const Heightfield terrain = roof(1.7, 300.0);
  const HeightClasses classes(terrain.values());
  const GroundRise rise(terrain);
  const SnowSlide slide(terrain);
  const Weather weather = this->weather();
  const std::size_t places = terrain.values().size();
  SnowpackField packs(places, Snowpack{});
  double in_mm = 0.0, out_mm = 0.0, slid_mm = 0.0;
  for (int step = 0; step < 8 * (60 + frames); ++step) {
    const WeatherMoment now = weather.at((3.0 * step + 7.5) * 3600.0 - weather.earlier_s());
    const FieldStep field_step = classes.step(now, 3.0, 0.0);
    const FactorMap drift = drift_factor(terrain, 90.0 * (step % 4), 0.5);
    for (std::size_t i = 0; i < places; ++i) {
      const snowpack::SnowStep here =
          std::get<SeasonStep>(field_step).at(classes.height_m(classes.of_place()[i]));
      snowpack::SnowState snow{packs.water_mm[i], packs.depth_m[i], packs.age[i],
                               step > 0 ? packs.liquid_mm[i] : 0.0,
                               step > 0 ? packs.lacking_mm[i] : 0.0};
      in_mm += drift.values()[i] * here.snow_mm + here.rain_mm;
      out_mm += snowpack::advance(snow, here, drift.values()[i],
                                  snowpack::sun_mm(here, rise.east[i], rise.north[i]), {});
    }
    advance(packs, classes, field_step, drift.values(), rise);
    const std::vector<double> before_mm = packs.water_mm;
    slide.settle(packs);
    for (std::size_t i = 0; i < places; ++i) {
      slid_mm += std::max(packs.water_mm[i] - before_mm[i], 0.0);
      ASSERT_EQ(packs.water_mm[i] > 0.0, packs.depth_m[i] > 0.0);
      ASSERT_LE(packs.liquid_mm[i], packs.water_mm[i]);
      ASSERT_GE(packs.lacking_mm[i], 0.0);
    }
  }
  const double lying_mm = std::accumulate(packs.water_mm.begin(), packs.water_mm.end(), 0.0);
  EXPECT_GT(slid_mm / static_cast<double>(places), 10.0);
  EXPECT_GT(lying_mm / static_cast<double>(places), 10.0);
  EXPECT_GT(out_mm, lying_mm);
  EXPECT_NEAR(in_mm, lying_mm + out_mm, 1e-9 * in_mm);
}

TEST_F(SeasonSnow, LiesDeeperHigherUpAndLongerOnNorthernSlopes) {
  scene.snow_cover.drifting = 0.0;
  const SnowGround ridge = ground(roof(0.5));  // 27 degrees, 160 m high
  const SnowGround plain = ground(Heightfield(2, 20.0, 0.0F));
  const SnowGround plateau = ground(Heightfield(2, 20.0, 160.0F));
  double south_mm = 0.0, north_mm = 0.0;
  int south_days = 0, north_days = 0;
  for (int frame = 1; frame <= frames; ++frame) {
    const SnowGround::State state = ridge.at(time_s(frame));
    EXPECT_GE(plateau.at(time_s(frame)).water_mm.at(0, 0),
              plain.at(time_s(frame)).water_mm.at(0, 0));
    const double south = state.water_mm.at(32, 16), north = state.water_mm.at(32, 48);
    south_mm += south, north_mm += north;
    south_days += south > 0.0, north_days += north > 0.0;
    EXPECT_GE(north, south);
  }
  EXPECT_GE(north_days, south_days + 3);
  EXPECT_GT(north_mm, 1.1 * south_mm);
}

TEST_F(SeasonSnow, FallsOnTheGroundWhenItFallsInTheAir) {
  const Weather weather = this->weather();
  const SnowGround level = ground(Heightfield(2, 20.0, 0.0F));
  double fallen_mm = 0.0;
  int snowy = 0, rainy = 0;
  for (int frame = 1; frame < frames; ++frame) {
    const double before_mm = level.at(time_s(frame)).fallen_mm;
    const double air_mm = weather.snow_mm_h(time_s(frame) + 3600.0 * 7.0, 0.0) * 24.0;
    fallen_mm = level.at(time_s(frame + 1)).fallen_mm;
    ASSERT_NEAR(fallen_mm - before_mm, air_mm, 1e-9 * fallen_mm) << frame;
    const double wet_mm = weather.at(time_s(frame) + 3600.0).precipitation_mm_h * 24.0;
    const double seen_mm_h = weather.falling_snow_mm_h(time_s(frame) + 3600.0 * 7.0, 0.0);
    EXPECT_NEAR(seen_mm_h * weather::wet_hours(wet_mm), air_mm, 1e-9) << frame;
    snowy += air_mm > 0.0, rainy += wet_mm > 0.0 && air_mm == 0.0;
  }
  EXPECT_GT(snowy, 10);
  EXPECT_GT(rainy, 5);
}

TEST_F(SeasonSnow, OfLargeGroundIsThatOfSmall) {
  const Heightfield terrain = roof(1.7);
  const test::TemporaryFolder tiles("season_tiles");
  const Weather weather = this->weather();
  LargeCover large(scene, large_ground(terrain), [&](double time_s) { return weather.at(time_s); },
                   tiles.path(), {.tile_samples = 64, .view_samples = 128});
  const SnowGround whole = ground(terrain);
  for (const double time_s : {time_s(40), time_s(40) + 1.5 * 3600.0, time_s(41)}) {
    const std::vector<CoverLevel> levels = large.view(time_s, {100.0, 100.0});
    ASSERT_EQ(levels.size(), 1U);
    const double step_s = 3.0 * 3600.0;
    const double begin_s =
        std::floor((time_s - this->time_s(40)) / step_s) * step_s + this->time_s(40);
    const auto before = whole.at(begin_s).depth_m, after = whole.at(begin_s + step_s).depth_m;
    const double fraction = (time_s - begin_s) / step_s;
    for (std::size_t i = 0; i < before.values().size(); ++i) {
      const double depth_m = std::lerp(before.values()[i], after.values()[i], fraction);
      ASSERT_NEAR(levels[0].depth_m[i], depth_m, 1e-5 * depth_m + 1e-6) << i;
    }
  }
}

}  // namespace
}  // namespace wold::snow
