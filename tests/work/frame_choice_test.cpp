#include "work/frame_choice.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace wold::work {
namespace {

using testing::ElementsAre;

/// A flight of three frames, gusts of two, snow of one.
scene::Scene three_shots() {
  scene::Scene scene;
  scene.film.frames_per_second = 2.0;
  for (const auto& [name, seconds] :
       {std::pair("flight", 1.5), std::pair("gusts", 1.0), std::pair("snow", 0.5)}) {
    scene::Shot shot;
    shot.name = name;
    shot.seconds = seconds;
    scene.shots.push_back(shot);
  }
  scene.ageing.frames.assign(6, 0.0);
  return scene;
}

std::string refusal(const FrameChoice& choice, const scene::Scene& scene) {
  try {
    chosen_frames(choice, scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FrameChoice, OfNothingIsAllFrames) {
  EXPECT_THAT(chosen_frames({}, three_shots()), ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(FrameChoice, OfAShotIsItsFrames) {
  const scene::Scene film = three_shots();
  EXPECT_THAT(chosen_frames({.shots = {"flight"}}, film), ElementsAre(1, 2, 3));
  EXPECT_THAT(chosen_frames({.shots = {"gusts"}}, film), ElementsAre(4, 5));
  EXPECT_THAT(chosen_frames({.shots = {"snow"}}, film), ElementsAre(6));
}

TEST(FrameChoice, OfShotsRisesWhateverTheirOrderAndHasNoneTwice) {
  EXPECT_THAT(chosen_frames({.shots = {"snow", "flight", "snow"}}, three_shots()),
              ElementsAre(1, 2, 3, 6));
}

TEST(FrameChoice, OfWhatIsNotThereIsRefused) {
  EXPECT_THAT(refusal({.numbers = {2, 7}}, three_shots()),
              testing::HasSubstr("--frames: found 7, expected frames from 1 to 6"));
  EXPECT_THAT(refusal({.shots = {"gust"}}, three_shots()),
              testing::HasSubstr("--shot: found \"gust\", expected one of flight, gusts, snow; did "
                                 "you mean \"gusts\"?"));
  EXPECT_THAT(refusal({.shots = {"gusts"}}, scene::Scene()),
              testing::HasSubstr("the scene has no [[shots]]"));
}

TEST(FrameRanges, AreWrittenAsTheyAreGiven) {
  EXPECT_EQ(ranges_text({1, 2, 3, 7}), "1-3,7");
  EXPECT_EQ(ranges_text({}), "");
}

}  // namespace
}  // namespace wold::work
