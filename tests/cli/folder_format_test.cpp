#include <gmock/gmock.h>

#include "core/files.h"
#include "small_film.h"

namespace wold::test {
namespace {

/// Data for POV-Ray in out, and what a newer program would have written about their format.
class FolderFormat : public SmallFilm {
 protected:
  void SetUp() override {
    SmallFilm::SetUp();
    ASSERT_EQ(wold(make).code, 0);
    ASSERT_TRUE(fs::exists(folder_ / "out/tasks/format.json"));
  }
  void make_newer() const {
    write_file(folder_ / "out/tasks/format.json", R"({"format": 2, "wold": "0.9.0"})");
  }

  const std::string make = "generate small.toml --renderer povray --quiet --out out";
};

void expect_refusal(const Result& result) {
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, testing::HasSubstr("that wold 0.9.0 has made"));
}

TEST_F(FolderFormat, OfANewerProgramIsLeftAlone) {
  make_newer();
  const auto before = times("out");
  for (const std::string& arguments :
       {make, std::string("plan small.toml --renderer povray --out out"),
        std::string("task small.toml texels 1 --renderer povray --out out"),
        std::string("film out"), std::string("report out")})
    expect_refusal(wold(arguments));
  EXPECT_EQ(times("out"), before);
}

TEST_F(FolderFormat, WhatTheRefusalSaysHelps) {
  make_newer();
  EXPECT_EQ(wold("generate out/scene.toml --renderer povray --quiet --out another").code, 0);
  EXPECT_EQ(contents("another"), contents("out"));
}

TEST_F(FolderFormat, CameAfterTheFirstFolders) {
  fs::remove(folder_ / "out/tasks/format.json");
  const auto before = times("out/povray");
  EXPECT_EQ(wold(make).code, 0);
  EXPECT_EQ(times("out/povray"), before);
}

}  // namespace
}  // namespace wold::test
