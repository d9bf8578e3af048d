#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/files.h"
#include "program.h"
#include "support/places.h"

/// What `wold` says of a scene that will look wrong, and of which it says nothing.
namespace wold::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Warnings : public Program {
 protected:
  /// What `check` says of a scene.
  std::string about(const std::string& toml, const std::string& options = "") const {
    write("a.toml", toml);
    const Result result = wold("check a.toml " + options);
    EXPECT_EQ(result.code, 0) << result.err;
    expect_contains(result.out, "name = \"meadow\"");
    return result.err;
  }
};

/// A camera that looks along the ground at half a radian, so that the picture's lower edge is at
/// 45 degrees: 1000 pixels a radian, the grass's middle sqrt(2) m away. A voxel of 0.6 m / 126
/// covers 3.4 pixels there, one of 0.6 m / 254 1.7.
constexpr const char* near_camera =
    "[camera]\neye = [21, 2]\ntarget = [21, 20]\neye_height = 1.16\ntarget_height = 1.16\n"
    "field_of_view = 90\n[render]\nsize = [2000, 2000]\n";

TEST_F(Warnings, TexelsTooCoarseForTheCamera) {
  const std::string coarse = about(near_camera, "--set 'grass.levels=[126, 30]'");
  EXPECT_THAT(coarse,
              AllOf(StartsWith("warning: grass looks coarse 1.4 m before the camera"),
                    HasSubstr("covers 3.4 pixels"), HasSubstr("grass.pixels_per_voxel = 1.3"),
                    HasSubstr("set render.grass = \"auto\"")));
  EXPECT_THAT(about(near_camera, "--set grass.pixels_per_voxel=2 --set 'grass.levels=[126, 30]'"),
              HasSubstr("set grass.levels = [254, 126, 30], or render.grass = \"auto\""));
  EXPECT_THAT(about(near_camera, "--set grass.pixels_per_voxel=2"), IsEmpty());
  EXPECT_THAT(about(near_camera, "--set render.grass=auto"), IsEmpty());
  EXPECT_THAT(about(near_camera, "--set camera.target_height=30"), IsEmpty()) << "it looks up";
  EXPECT_THAT(about("[camera]\neye_end = [21, 10, 0.3]\n"), HasSubstr("looks coarse"));
}

TEST_F(Warnings, FarCellsBelowAPixel) {
  // 0.32 m over some 298 m of 1170 pixels a radian.
  const std::string far = "[terrain]\nsize = 300\n[render]\nsize = [1218, 685]\n";
  EXPECT_THAT(about(far, "--set grass.far_field_below_pixels=0 --set grass.height=0.1"),
              AllOf(StartsWith("warning: grass 298 m away is 0.39 pixels high"),
                    HasSubstr("set grass.far_field_below_pixels = 1.2")));
  EXPECT_THAT(about(far), IsEmpty());
  EXPECT_THAT(about("", "--set grass.far_field_below_pixels=0"), IsEmpty()) << "nothing is so far";
}

TEST_F(Warnings, ShrubsAsVolumesInMitsuba) {
  const std::string shrubs =
      "[render]\nrenderer = \"mitsuba\"\n[[species]]\nname = \"grass\"\n"
      "[[species]]\nname = \"juniper\"\ncrown = 0.4\nheight = 0.04\ncover = 0.2\n";
  EXPECT_THAT(about(shrubs), HasSubstr("warning: Mitsuba shows one volume at a place"));
  EXPECT_THAT(about(shrubs, "--grass blades"), Not(HasSubstr("Mitsuba")));
  EXPECT_THAT(about(shrubs, "--renderer povray"), Not(HasSubstr("Mitsuba")));
  EXPECT_THAT(about("[render]\nrenderer = \"mitsuba\"\n"), Not(HasSubstr("one volume")));
}

TEST_F(Warnings, ASunThatTheDateHasAlready) {
  const std::string day = "[sun]\ndate = [2026, 6, 21]\nlatitude = 47\ntime = 12\n";
  EXPECT_THAT(about(day), IsEmpty());
  EXPECT_THAT(about(day + "elevation = 5\n"),
              StartsWith("warning: sun.elevation changes nothing: sun.date and sun.time say"));
  EXPECT_THAT(about(day + "azimuth = 100\n"), StartsWith("warning: sun.azimuth changes nothing"));
  EXPECT_THAT(about("[sun]\nelevation = 5\nazimuth = 100\n"), IsEmpty());
}

TEST_F(Warnings, CloudsBehindRain) {
  const std::string clouds = "[[clouds]]\nkind = \"cumulus\"\n";
  EXPECT_THAT(about(clouds + "[weather]\nprecipitation = 0.5\ntemperature = 5\n"),
              HasSubstr("weather.precipitation hides the sun and [[clouds]]"));
  EXPECT_THAT(about(clouds), IsEmpty());
  EXPECT_THAT(about("[weather]\nprecipitation = 0.5\ntemperature = 5\n"), IsEmpty());
}

TEST_F(Warnings, ASquareOfAFewCellsOfTheElevationModel) {
  std::string model = "ncols 80\nnrows 80\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
  for (int i = 0; i < 6400; ++i) model += std::to_string(600 + i % 7) + (i % 80 == 79 ? "\n" : " ");
  write("hill.asc", model);
  const std::string hill = "[terrain]\nelevation = \"hill.asc\"\n";
  EXPECT_THAT(about(hill), HasSubstr("the terrain is 42 m wide, 4.2 cells of terrain.elevation; "
                                     "set terrain.size, and camera.eye"));
  EXPECT_THAT(about(hill + "size = 600\n"),
              HasSubstr("the camera has its default place, in the corner of 600 m"));
  EXPECT_THAT(about(hill + "size = 60\n"), IsEmpty()) << "somebody chose it";
  EXPECT_THAT(about(hill + "size = 400\n"), Not(HasSubstr("cells of terrain.elevation")));
}

TEST_F(Warnings, CloudsThatJump) {
  // 20 m/s over 600 s are 12 km, cirrus has cells of less.
  const std::string film =
      "[ageing]\nframes = [0, 0, 0, 0, 0, 0, 0, 0]\n[[clouds]]\nkind = 'cumulus'\nspeed = 1\n"
      "[[clouds]]\nkind = 'cirrus'\ncell = 3000\nspeed = 20\n[film]\nframe_seconds = ";
  const std::string jump = about(film + "600\n");
  EXPECT_THAT(jump, AllOf(StartsWith("warning: clouds[2] jump 1.2e+04 m"),
                          HasSubstr("set film.frame_seconds = 15, or clouds[2].speed = 0.5")));
  EXPECT_THAT(about(film + "15\n"), IsEmpty());
  EXPECT_THAT(about(film + "600\n", "--set 'ageing.frames=[0, 0.3]'"), IsEmpty()) << "no film";
}

TEST_F(Warnings, BlowingSnowWithoutStormOrSnow) {
  const std::string blowing = "[snow_cover]\nblowing = 3\n";
  EXPECT_THAT(about(blowing), StartsWith("warning: snow_cover.blowing changes nothing without"));
  EXPECT_THAT(about(blowing + "initial = 50\n[wind]\nspeed = 3\n[weather]\ntemperature = -5\n"),
              HasSubstr("snow_cover.blowing changes nothing without"));
  EXPECT_THAT(about(blowing + "initial = 50\n[wind]\nspeed = 12\n[weather]\ntemperature = -5\n"),
              Not(HasSubstr("snow_cover.blowing")));
}

TEST_F(Warnings, SnowThatCannotBeSeen) {
  EXPECT_THAT(about("[snow_cover]\ninitial = 30\ncover = 'none'\n"),
              HasSubstr("set snow_cover.cover = \"depth\""));
  // 3 mm a day and degree: 30 mm are gone after a day at 10 degrees, but for the hill's height.
  const std::string thaw = "[snow_cover]\ninitial = 30\n[weather]\ntemperature = 10\nearlier = ";
  EXPECT_THAT(about(thaw + "26\n"), HasSubstr("has melted before the first frame"));
  EXPECT_THAT(about(thaw + "23\n"), IsEmpty());
  EXPECT_THAT(about("[weather]\nprecipitation = 2\n", "--set snowfall.shutter=0.5"),
              HasSubstr("set snowfall.shutter = 0.003"));
  EXPECT_THAT(about("[weather]\nprecipitation = 2\n"), IsEmpty());
}

TEST_F(Warnings, ASeasonWhoseTableBeginsWithIt) {
  std::string table = "date,tmin_c,tmax_c,precipitation_mm\n";
  for (int month = 3; month <= 12; ++month)
    for (int day = 1; day <= 28; ++day)
      table += fmt::format("2026-{:02}-{:02},4,14,2\n", month, day);
  write("w.csv", table);
  const auto season = [](const std::string& first) {
    return fmt::format("[season]\ntable = 'w.csv'\nfirst = {}\nlast = [2026, 11, 1]\n", first);
  };
  EXPECT_THAT(about(season("[2026, 3, 11]")),
              AllOf(StartsWith("warning: season.table begins 10 days before the first frame"),
                    HasSubstr("begin on 2026-01-10 or earlier"),
                    HasSubstr("season.first = [2026, 4, 30] or later")));
  EXPECT_THAT(about(season("[2026, 5, 1]")), IsEmpty());
}

/// A table of the whole year.
std::string days_of_2026(const std::string& more_columns = "", const std::string& more = "") {
  std::string table = "date,tmin_c,tmax_c,precipitation_mm" + more_columns + "\n";
  for (int month = 1; month <= 12; ++month)
    for (int day = 1; day <= 28; ++day)
      table += fmt::format("2026-{:02}-{:02},4,14,2{}\n", month, day, more);
  return table;
}

constexpr const char* autumn = "[season]\nfirst = [2026, 8, 25]\nlast = [2026, 11, 1]\n";

TEST_F(Warnings, SeasonKeysThatWinOverTheTable) {
  write("w.csv", days_of_2026());
  write("clouds.csv", days_of_2026(",cloud_cover", ",0.5"));
  const std::string keys =
      std::string(autumn) +
      "[[season_keys]]\ndate = [2026, 9, 1]\ntemperature = 3\ncloud_cover = 1\n"
      "[[season_keys]]\ndate = [2026, 9, 20]\ntemperature = 3\nweathering = 0.5\n";
  EXPECT_THAT(about(keys), IsEmpty());
  EXPECT_THAT(about(keys, "--weather w.csv"),
              AllOf(StartsWith("warning: [[season_keys]] win over season.table"),
                    HasSubstr("weathering (on 1 day), temperature (on 2 days)"),
                    Not(HasSubstr("cloud_cover")), Not(HasSubstr("precipitation"))));
  EXPECT_THAT(about(keys, "--weather clouds.csv"), HasSubstr(", cloud_cover (on 1 day);"));
  EXPECT_THAT(about(autumn, "--weather w.csv"), IsEmpty());
}

TEST_F(Warnings, SeasonKeysOutsideTheSeason) {
  const auto key = [](const std::string& date) {
    return "[[season_keys]]\nweathering = 0.5\ndate = " + date + "\n";
  };
  const std::string ends = key("[2026, 8, 25]") + key("[2026, 11, 1]");
  EXPECT_THAT(about(autumn + ends), IsEmpty());
  EXPECT_THAT(about(autumn + key("[2026, 8, 24]") + ends + key("[2026, 11, 2]")),
              AllOf(StartsWith("warning: 2 of the 4 [[season_keys]] lie outside the season, "
                               "2026-08-25 to 2026-11-01"),
                    HasSubstr("season_keys[1] (2026-08-24), season_keys[4] (2026-11-02)")));
}

TEST_F(Warnings, ATerrainCoarserThanItsElevationModel) {
  std::string model = "ncols 41\nnrows 41\nxllcorner 0\nyllcorner 0\ncellsize 30\n";
  for (int cell = 0; cell < 41 * 41; ++cell) model += fmt::format("{} ", 100 + cell % 7);
  write("dem.asc", model);
  const std::string scene = "[terrain]\nelevation = \"dem.asc\"\nsize = 1200\n";
  EXPECT_THAT(
      about(scene, "--set terrain.samples=17"),
      AllOf(HasSubstr("the terrain has a height each 75 m"),
            HasSubstr("terrain.elevation one each 30 m"), HasSubstr("set terrain.samples = 41")));
  EXPECT_THAT(about(scene, "--set terrain.samples=41"), Not(HasSubstr("terrain.samples")));
  EXPECT_THAT(about(scene, "--set terrain.samples=31"), Not(HasSubstr("terrain.samples")));
}

// As people get them: a grid of degrees that does not say so.
TEST_F(Warnings, AnElevationModelInDegreesThatIsTakenForMetres) {
  std::string model = "ncols 41\nnrows 41\nxllcorner 7\nyllcorner 46\ncellsize 0.0008333\n";
  for (int cell = 0; cell < 41 * 41; ++cell) model += fmt::format("{} ", 100 + cell % 7);
  write("dem.asc", model);
  const std::string scene = "[terrain]\nelevation = \"dem.asc\"\n";
  EXPECT_THAT(about(scene), AllOf(HasSubstr("set terrain.system = \"EPSG:4326\""),
                                  Not(HasSubstr("terrain.samples"))));
  EXPECT_THAT(about(scene + "system = \"EPSG:4326\"\nsize = 1200\n"), Not(HasSubstr("EPSG:4326")));
}

TEST_F(Warnings, ATornadoThatNobodySees) {
  const std::string tornado = "[wind]\nfield = 'tornado'\n";
  EXPECT_THAT(about(tornado), AllOf(StartsWith("warning: the tornado of wind.field"),
                                    HasSubstr("set snowfall.strength = \"moderate\"")));
  EXPECT_THAT(about(tornado, "--set snowfall.strength=moderate"), IsEmpty());
  EXPECT_THAT(about(tornado, "--set weather.precipitation=1.2"), IsEmpty());
  EXPECT_THAT(about(tornado, "--set weather.precipitation=1.2 --set weather.temperature=8"),
              HasSubstr("tornado"))
      << "it rains";
}

TEST_F(Warnings, KeysThatPaperMotionDoesNotHave) {
  const std::string clouds =
      "[[clouds]]\nspeed = 3\ngusts = 1\n[[cloud_events]]\nkind = 'wind'\nspeed = 2\n";
  EXPECT_THAT(about(clouds), IsEmpty());
  const std::string paper = clouds + "[[clouds]]\nmotion = 'paper'\n";
  EXPECT_THAT(about(paper), AllOf(StartsWith("warning: clouds[2].motion = \"paper\""),
                                  HasSubstr(": cloud_events[1].speed changes nothing")));
  EXPECT_THAT(
      about(paper + "heading = 20\nspeed = 3\n"),
      HasSubstr("clouds[2].speed, clouds[2].heading, cloud_events[1].speed change nothing"));
}

TEST_F(Warnings, KeysOfAnotherChoice) {
  EXPECT_EQ(
      about("[snow_cover]\nwhite_after = 5\n"),
      "warning: snow_cover.white_after changes nothing without snow_cover.cover = \"paper\"\n");
  EXPECT_THAT(about("[snow_cover]\nwhite_after = 5\ncover = 'paper'\n"), IsEmpty());
  EXPECT_THAT(about("[terrain]\nsystem = 'EPSG:4326'\n"), HasSubstr("without terrain.elevation"));
  EXPECT_EQ(about("[film]\nshutter = 0.5\n"),
            "warning: film.shutter changes nothing without a camera that moves or wind.grass = "
            "\"waving\"\n");
  EXPECT_THAT(about("[film]\nshutter = 0.5\n[wind]\ngrass = 'waving'\n"), IsEmpty());
}

TEST_F(Warnings, PatchesOfASpeciesThatGrowsEverywhere) {
  const std::string species = "[[species]]\n[[species]]\nfeature = 2\n";
  EXPECT_THAT(about(species), StartsWith("warning: species[2].feature changes nothing"));
  EXPECT_THAT(about(species + "cover = 0.4\n"), IsEmpty());
}

TEST_F(Warnings, KeysOfLeavesAndOfPetalsWhereThereAreNone) {
  const std::string flower = "[[species]]\npetals = 5\npetal_colour = 'blue'\n";
  EXPECT_THAT(about(flower), IsEmpty());
  EXPECT_THAT(about(flower + "bend = 0.2\nlitter = 0.1\n"),
              StartsWith("warning: species[1]: bend, litter change nothing of stiff stalks"));
  EXPECT_THAT(about("[grass]\nbend = 0.2\n" + flower), IsEmpty());
  EXPECT_THAT(about("[[species]]\npetal_colour = 'blue'\n"),
              HasSubstr("changes nothing; set species[1].petals"));
}

TEST_F(Warnings, KeysThatWereRenamed) {
  write("a.toml", "[growth]\nshare = 0.9\n");
  const std::string renamed = "warning: a.toml:2:1: growth.share is the old name of growth.cover";
  for (const std::string command : {"check", "render --dry-run", "curves --out a.csv"})
    EXPECT_THAT(wold(command + " a.toml").err, StartsWith(renamed)) << command;
  EXPECT_THAT(wold("check a.toml").out,
              AllOf(HasSubstr("\ncover = 0.9\n"), Not(HasSubstr("\nshare = "))));
}

TEST_F(Warnings, StandOnStderrOfWhatUsesTheScene) {
  write("a.toml", std::string(near_camera) + "[grass]\nlevels = [126]\n");
  for (const std::string command : {"check", "render --dry-run", "generate --dry-run"}) {
    const Result result = wold(command + " a.toml");
    EXPECT_EQ(result.code, 0);
    EXPECT_THAT(result.err, StartsWith("warning: grass looks coarse")) << command;
    EXPECT_THAT(result.out, Not(HasSubstr("warning")));
  }
  make_folder(folder_ / "out");
  write("out/scene.toml", wold("check a.toml").out);
  EXPECT_EQ(wold("report out --quiet").code, 0);
  expect_contains(read_file(folder_ / "out/report.html"), "Scene: grass looks coarse");
}

TEST_F(Warnings, AreNotOfTheExamples) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(tests_folder() / "../examples")) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    const Result result = wold("check " + quoted(entry.path().string()));
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "") << entry.path();
  }
  EXPECT_GE(scenes, 10);
}

}  // namespace
}  // namespace wold::test
