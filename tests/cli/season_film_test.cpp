#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "small_film.h"

/// A season as files.
namespace wold::test {
namespace {

constexpr const char* season = R"(
[season]
first = [2026, 9, 20]
last = [2026, 11, 19]
frames = 5
[[season_keys]]
date = [2026, 9, 20]
weathering = 0.1
temperature = 9
precipitation = 0
cloud_cover = 0.2
[[season_keys]]
date = [2026, 11, 1]
weathering = 0.9
temperature = -6
precipitation = 8
cloud_cover = 1
[[clouds]]
kind = "cumulus"
cells = [2, 2]
)";

class SeasonFilm : public SmallFilm {
 protected:
  void SetUp() override {
    SmallFilm::SetUp();
    write("season.toml", read_file(folder_ / "small.toml") + season);
  }

  void generate(const std::string& folder, const std::string& options) const {
    const Result result =
        wold("generate season.toml --quiet --renderer both --out " + folder + " " + options);
    ASSERT_EQ(result.code, 0) << result.err;
  }

  std::map<std::string, std::string> frame(const std::string& folder, const char* renderer,
                                           int number) const {
    return contents(fmt::format("{}/{}/data/frame_{:04}", folder, renderer, number));
  }

  nlohmann::json facts(int number) const {
    return nlohmann::json::parse(
        read_file(folder_ / fmt::format("whole/blender/data/frame_{:04}/frame.json", number)));
  }
};

// Snow, clouds, sun and withering have come a long way by frame 4; on its own it is the same.
TEST_F(SeasonFilm, AFrameAloneIsTheFrameOfTheWholeFilm) {
  generate("whole", "--threads 1");
  generate("alone", "--frames 4");
  for (const char* renderer : {"blender", "povray"}) {
    const auto wanted = frame("whole", renderer, 4);
    EXPECT_FALSE(wanted.empty());
    EXPECT_THAT(different(frame("alone", renderer, 4), wanted), testing::IsEmpty()) << renderer;
    EXPECT_THAT(different(frame("whole", renderer, 3), wanted), testing::Not(testing::IsEmpty()));
  }
  EXPECT_EQ(facts(1).at("weathering"), 0.1);
  EXPECT_EQ(facts(5).at("weathering"), 0.9);
  const double first_z = facts(1).at("daylight").at("to_sun").at(2);
  const double last_z = facts(5).at("daylight").at("to_sun").at(2);
  EXPECT_GT(first_z, last_z + 0.2);  // the sun sinks by 20 degrees
}

}  // namespace
}  // namespace wold::test
