#include <gmock/gmock.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <numbers>
#include <thread>

#include "core/files.h"
#include "scene/sun_position.h"
#include "small_film.h"

/// A film of shots as files: a flight on one day, live wind on another, snow at the end.
namespace wold::test {
namespace {

constexpr const char* film = R"(name = "shots"
seed = 3
[terrain]
size = 6
samples = 49
[grass]
blades = 30
variants = 1
levels = [30]
key_frames = [0.0, 0.5, 1.0]
[wind]
grass = "waving"
speed = 8
[season]
first = [2026, 9, 20]
last = [2026, 11, 20]
[[season_keys]]
date = [2026, 9, 20]
weathering = 0.1
temperature = 9
precipitation = 0
[[season_keys]]
date = [2026, 10, 25]
precipitation = 0
[[season_keys]]
date = [2026, 11, 1]
weathering = 0.9
temperature = -6
precipitation = 12
[sun]
latitude = 46.5
longitude = 8
[camera]
eye = [3, 0.5]
eye_height = 1
target = [3, 4]
[render]
renderer = "povray"
size = [64, 36]
samples = 1
[film]
frames_per_second = 2
[[shots]]
name = "flight"
date = [2026, 9, 22]
time = 9
seconds = 1.5
frame_seconds = 1800
eye = [1, 0.5]
eye_end = [5, 1.5, 2]
[[shots]]
name = "gusts"
date = [2026, 10, 10]
time = 12
seconds = 1
frame_seconds = 0.5
[[shots]]
name = "snow"
date = [2026, 11, 12]
time = 14.5
seconds = 0.5
field_of_view = 40
)";
constexpr int frames = 6;

class FilmOfShots : public SmallFilm {
 protected:
  void SetUp() override {
    SmallFilm::SetUp();
    write("shots.toml", film);
  }

  void generate(const std::string& folder, const std::string& options = "") const {
    const Result result =
        wold("generate shots.toml --quiet --renderer both --out " + folder + " " + options);
    ASSERT_EQ(result.code, 0) << result.err;
  }

  nlohmann::json facts(int number) const {
    return nlohmann::json::parse(
        read_file(folder_ / fmt::format("whole/blender/data/frame_{:04}/frame.json", number)));
  }
};

/// Unit vector to the sun of a moment.
std::array<double, 3> to_sun(std::chrono::year_month_day date, double hour) {
  const scene::SunPosition sun = scene::sun_position(date, hour, 46.5, 8.0);
  constexpr double radians_per_degree = std::numbers::pi / 180.0;
  const double up = sun.elevation_deg * radians_per_degree;
  const double turn = sun.azimuth_deg * radians_per_degree;
  return {std::cos(up) * std::sin(turn), std::cos(up) * std::cos(turn), std::sin(up)};
}

TEST_F(FilmOfShots, ShowsItsDaysTimesAndCameras) {
  using namespace std::chrono;
  generate("whole");
  const auto expect = [&](int frame, year_month_day date, double hour, double eye_x) {
    const nlohmann::json json = facts(frame);
    const std::array<double, 3> sun = to_sun(date, hour);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(json.at("daylight").at("to_sun").at(axis), sun[axis], 1e-5) << frame;
    EXPECT_NEAR(json.at("camera").at("eye_m").at(0), eye_x, 1e-6) << frame;
    const double day =
        static_cast<double>((sys_days(date) - sys_days(2026y / September / 20)).count());
    EXPECT_NEAR(json.at("time_s"), day * 86400.0 + hour * 3600.0, 1e-3) << frame;
    const double days_of_42 = std::min(42.0, day + (hour - 12.0) / 24.0);
    EXPECT_NEAR(json.at("weathering"), 0.1 + 0.8 * days_of_42 / 42.0, 1e-6) << frame;
  };
  for (int i = 0; i < 3; ++i) expect(1 + i, 2026y / September / 22, 9.0 + 0.5 * i, 1.0 + 2.0 * i);
  for (int i = 0; i < 2; ++i) expect(4 + i, 2026y / October / 10, 12.0 + i * 0.5 / 3600.0, 3.0);
  expect(6, 2026y / November / 12, 14.5, 3.0);
  EXPECT_EQ(facts(6).at("camera").at("field_of_view_deg"), 40.0);
  EXPECT_EQ(facts(5).at("camera").at("field_of_view_deg"), 55.0);
  // Half a second of wind moves the grass, and nothing falls but in the last shot.
  EXPECT_THAT(different(contents("whole/blender/data/frame_0004"),
                        contents("whole/blender/data/frame_0005")),
              testing::Not(testing::IsEmpty()));
  for (int frame = 1; frame <= frames; ++frame)
    EXPECT_EQ(fs::exists(folder_ /
                         fmt::format("whole/blender/data/frame_{:04}/flake_corners_m.f32", frame)),
              frame == 6)
        << frame;
}

TEST_F(FilmOfShots, AFrameAloneIsTheFrameOfTheWholeFilm) {
  generate("whole", "--threads 1");
  generate("alone", "--frames 5");
  for (const char* renderer : {"blender", "povray"}) {
    const std::string data = fmt::format("/{}/data/frame_0005", renderer);
    EXPECT_FALSE(contents("whole" + data).empty());
    EXPECT_THAT(different(contents("alone" + data), contents("whole" + data)), testing::IsEmpty());
  }
}

TEST_F(FilmOfShots, WhatItsFolderSaysReadsBackAsTheSameFilm) {
  generate("whole", "--frames 1");
  const Result check = wold("check whole/scene.toml");
  EXPECT_EQ(check.code, 0) << check.err;
  const Result plan = wold("plan whole/scene.toml --out whole --frames 1 --renderer both");
  EXPECT_EQ(plan.code, 0) << plan.err;
  expect_contains(plan.out, "frames 1 of 6");
  expect_contains(plan.out, "\n  shots: flight 1-3, gusts 4-5, snow 6\n");
  const Result renamed =
      wold("plan shots.toml --out whole --frames 1 --renderer both --set shots[1].name=dawn");
  expect_contains(renamed.out, "  shots: dawn 1-3");
  expect_contains(renamed.out, "\n  scenes  0 of 1 to do");
  const Result beyond = wold("generate shots.toml --out whole --frames 7");
  EXPECT_EQ(beyond.code, 2);
  expect_contains(beyond.err, "found 7, expected frames from 1 to 6");
}

TEST_F(FilmOfShots, KilledItGoesOnToTheSameBytes) {
  if (!is_installed("povray")) GTEST_SKIP() << "no povray on this machine";
  const std::string line = command("render shots.toml --quiet --out ");
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(shell(line + "undisturbed").code, 0);
  const auto whole = std::chrono::steady_clock::now() - start;
  for (const double part : {0.2, 0.5, 0.8}) {
    Running program(folder_, line + "out");
    std::this_thread::sleep_for(whole * part);
    program.send(SIGKILL);
    program.finish();
  }
  const Result last = shell(line + "out");
  EXPECT_EQ(last.code, 0) << last.err;
  EXPECT_THAT(different(contents("out"), contents("undisturbed")), testing::IsEmpty());
  expect_nothing_half_written("out");
}

TEST_F(FilmOfShots, OneShotIsMadeAndPlayedAlone) {
  if (!is_installed("povray") || !is_installed("ffprobe"))
    GTEST_SKIP() << "no povray or ffmpeg on this machine";
  ASSERT_EQ(wold("render shots.toml --quiet --out out --shot gusts").code, 0);
  for (int frame = 1; frame <= frames; ++frame)
    EXPECT_EQ(fs::exists(folder_ / fmt::format("out/frames/povray/{:04}.png", frame)),
              frame == 4 || frame == 5)
        << frame;
  ASSERT_EQ(wold("film out --quiet --shot gusts").code, 0);
  EXPECT_EQ(shell("ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 "
                  "out/film_povray.mp4")
                .out,
            "2\n");
  const Result apart = wold("film out --shot flight --shot snow");
  EXPECT_EQ(apart.code, 2);
  expect_contains(apart.err, "--shot: found 1-3,6, expected frames without gaps, such as 1-6");
  expect_contains(wold("film out --frames 1,4").err,
                  "--frames: found 1,4, expected frames without");
  const Result both = wold("plan shots.toml --shot gusts --frames 1");
  EXPECT_EQ(both.code, 2);
  expect_contains(both.err, "--frames excludes --shot");
}

TEST_F(FilmOfShots, OfAFarmRepeatsItsShotInEachTask) {
  const auto job =
      nlohmann::json::parse(wold("plan shots.toml --out out --shot gusts --openjd").out);
  const nlohmann::json& task = job.at("steps").at(0);
  const std::vector<std::string> words =
      task.at("script").at("actions").at("onRun").at("args").get<std::vector<std::string>>();
  const auto shot = std::ranges::find(words, "--shot");
  ASSERT_LT(shot + 1, words.end());
  EXPECT_EQ(*(shot + 1), "gusts");
}

TEST_F(FilmOfShots, IsPlayedAtItsOwnSpeed) {
  if (!is_installed("povray") || !is_installed("ffprobe"))
    GTEST_SKIP() << "no povray or ffmpeg on this machine";
  ASSERT_EQ(wold("render shots.toml --quiet --out out").code, 0);
  const Result made = wold("film out --quiet");
  EXPECT_EQ(made.code, 0) << made.err;
  const Result probed = shell(
      "ffprobe -v error -count_frames -show_entries stream=r_frame_rate,nb_read_frames -of "
      "csv=p=0 out/film_povray.mp4");
  EXPECT_EQ(probed.out, "2/1,6\n");
}

}  // namespace
}  // namespace wold::test
