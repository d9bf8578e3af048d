#include "place/ground_views.h"

#include <gtest/gtest.h>

namespace wold::place {
namespace {

// Three pictures, each inside the one before, seen from above: what a finer one shows is asked of
// that alone, but for a border that they share.
TEST(ViewsOfPictures, ShareTheGroundAmongThem) {
  const GroundGrid whole{{{0.0, 0.0}, 400.0}, 401};
  const std::vector<GroundGrid> details = {{{{100.0, 100.0}, 200.0}, 401},
                                           {{{190.0, 190.0}, 20.0}, 201}};
  const View above({{200.0, 200.0, 900.0}, {200.0, 201.0, 0.0}, 60.0}, 100, 100);
  const std::vector<View> views =
      views_of_pictures(above, whole, details, [](const Square&) { return false; });
  ASSERT_EQ(views.size(), 3U);
  const auto asked = [&](std::size_t picture, double east_m) {
    return views[picture].may_see_ground({east_m, 200.0, 0.0}, 0.0);
  };
  EXPECT_TRUE(asked(0, 50.0));
  EXPECT_TRUE(asked(0, 104.0));  // two steps of the soft border and four more
  EXPECT_FALSE(asked(0, 107.0));
  EXPECT_TRUE(asked(1, 150.0));
  EXPECT_TRUE(asked(1, 192.0));
  EXPECT_FALSE(asked(1, 194.0));
  EXPECT_TRUE(asked(2, 200.0));
}

// Above ground that nothing stands on it is enough to look a little beside what is seen; boulders
// and snow are seen where their foot is not.
TEST(ViewsOfPictures, ReachAsFarAsWhatStandsInThem) {
  const GroundGrid whole{{{0.0, 0.0}, 400.0}, 401};
  const std::vector<GroundGrid> details = {
      {{{100.0, 100.0}, 200.0}, 401}, {{{190.0, 190.0}, 20.0}, 201}, {{{195.0, 195.0}, 5.0}, 201}};
  const View view({{200.0, 200.0, 2.0}, {200.0, 300.0, 0.0}, 60.0}, 100, 100);
  const std::vector<View> views = views_of_pictures(
      view, whole, details, [](const Square& square) { return square.size_m == 20.0; });
  ASSERT_EQ(views.size(), 4U);
  EXPECT_DOUBLE_EQ(views[0].reach_m(), 2.0);
  EXPECT_DOUBLE_EQ(views[1].reach_m(), 2.0);
  EXPECT_DOUBLE_EQ(views[2].reach_m(), 2.0);
  EXPECT_DOUBLE_EQ(views[3].reach_m(), 0.25);
}

TEST(ViewsOfPictures, OfNoDetailsAreTheViewAlone) {
  const View view({{5.0, 5.0, 2.0}, {5.0, 30.0, 0.0}, 60.0}, 100, 100);
  const auto views = views_of_pictures(view, {{{0.0, 0.0}, 40.0}, 41}, {}, {});
  ASSERT_EQ(views.size(), 1U);
  EXPECT_TRUE(views[0].may_see_ground({5.0, 20.0, 0.0}, 0.0));
}

// A camera that stands has one view however long the film is; one that flies has too many.
TEST(ViewsOfFilm, AreOneForEachCamera) {
  scene::Scene scene;
  scene.ageing.frames.assign(20, 0.5);
  const Heightfield flat(17, scene.terrain.size_m);
  EXPECT_EQ(views_of_film(scene, flat).size(), 1U);
  scene.camera.eye_end = {scene.camera.eye_m[0] + 5.0, scene.camera.eye_m[1], 2.0};
  EXPECT_TRUE(views_of_film(scene, flat).empty());
  scene.ageing.frames.assign(8, 0.5);
  EXPECT_EQ(views_of_film(scene, flat).size(), 8U);
}

}  // namespace
}  // namespace wold::place
