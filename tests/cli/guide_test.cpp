#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>

#include "core/files.h"
#include "program.h"
#include "support/places.h"

namespace wold::test {
namespace {

/// The commands of examples/guide.md, in order, without "wold ".
std::vector<std::string> commands_of_guide() {
  const std::string start = "    wold ";
  std::vector<std::string> commands;
  std::istringstream lines(read_file(tests_folder() / ".." / "examples" / "guide.md"));
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(start, 0) == 0) commands.push_back(line.substr(start.size()));
  return commands;
}

/// A hill, 41 x 41 heights 30 m apart.
std::string elevation_model() {
  std::string text =
      "ncols 41\nnrows 41\nxllcorner 600000\nyllcorner 150000\ncellsize 30\nNODATA_value -9999\n";
  for (int row = 0; row < 41; ++row) {
    for (int column = 0; column < 41; ++column)
      text +=
          fmt::format("{} ", 1200.0 + 150.0 * std::exp(-std::hypot(row - 20, column - 20) / 9.0));
    text += '\n';
  }
  return text;
}

/// Two years of a cool, wet place, by the month.
std::string daily_weather() {
  std::string text = "date,tmin_c,tmax_c,precipitation_mm\n";
  for (int month = 0; month < 24; ++month)
    for (int day = 1; day <= 28; ++day) {
      const double warmth = -std::cos(2.0 * std::numbers::pi * (month + day / 28.0) / 12.0);
      text += fmt::format("{}-{:02}-{:02},{:.1f},{:.1f},{}\n", 2025 + month / 12, month % 12 + 1,
                          day, 2.0 + 8.0 * warmth, 10.0 + 10.0 * warmth, day % 4 == 0 ? 9 : 0);
    }
  return text;
}

/// The same command for as small pictures and as few frames as will do.
std::string shrunk(std::string command) {
  command = std::regex_replace(command, std::regex(" --size [0-9x]+"), "");
  const bool all_frames = command.find("--frames") == std::string::npos;
  return command +
         " --set 'render.size=[64,36]' --set render.samples=1 --set terrain.samples=65 "
         "--set terrain.size=26 --set terrain.hill_height=3 --set terrain.relief=0.3 "
         "--set terrain.relief_feature=10 --set 'camera.eye=[13,2]' --set 'camera.target=[13,18]' "
         "--set 'paths[1].way=[13,4,14,20]' --set grass.variants=1 --set 'grass.levels=[30]' --set "
         "'grass.key_frames=[0,0.5,1]'" +
         (all_frames ? " --set season.frames=3" : "");
}

class Guide : public Program {};

TEST_F(Guide, CommandsDoWhatItSays) {
  if (!can_render("blender") || !is_installed("ffmpeg"))
    GTEST_SKIP() << "no complete blender or no ffmpeg on this machine: the guide is not tested";
  write("mountain.asc", elevation_model());
  write("days.csv", daily_weather());
  const std::vector<std::string> commands = commands_of_guide();
  EXPECT_GE(commands.size(), 8U);
  for (const std::string& command : commands) {
    const Result result = wold(command.rfind("render", 0) == 0 ? shrunk(command) : command);
    EXPECT_EQ(result.code, 0) << command << '\n' << result.err;
  }
  for (const char* file : {"out/my_autumn/preview.png", "with_mountain.png", "days.svg",
                           "out/trial/frames/blender/0012.png", "out/my_autumn/film_blender.mp4",
                           "out/my_autumn/report.html"})
    EXPECT_TRUE(fs::exists(folder_ / file)) << file;
}

/// The example of a command's manual page, without "wold ".
std::string example_on_page(const std::string& page) {
  const std::string start = ".EX\nwold ";
  const std::size_t from = page.find(start) + start.size();
  return std::regex_replace(page.substr(from, page.find('\n', from) - from), std::regex(R"(\\(.))"),
                            "$1");
}

// As they stand on the pages, one after the other, with a scene of that name which is small.
TEST_F(Guide, ExamplesOfManualPagesWork) {
  for (const char* program : {"povray", "ffmpeg"})
    if (!is_installed(program))
      GTEST_SKIP() << "no " << program << " on this machine: the examples are not tested";
  const auto run = [&](const std::string& command) {
    const std::string example = example_on_page(wold(command + " --man").out);
    EXPECT_EQ(example.rfind(command + ' ', 0), 0U) << example;
    const Result result = wold(example);
    EXPECT_EQ(result.code, 0) << example << '\n' << result.err;
  };
  run("new");
  write("meadow.toml", wold(shrunk("check meadow.toml")).out);
  for (const char* command : {"check", "plan", "task", "generate", "render", "inspect", "preview",
                              "curves", "wind", "film"})
    run(command);
  for (const char* copy : {"got.png", "want.png"})
    fs::copy_file(folder_ / "out/meadow/frames/povray/0001.png", folder_ / copy);
  run("compare");
  run("report");
}

}  // namespace
}  // namespace wold::test
