#include "grass/geometry/crown.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "grass/geometry/blade.h"

namespace wold::grass {
namespace {

constexpr double crown_m = 0.7, patch_m = 1.2, leaf_m = 0.1;
constexpr Crown::Size usual{crown_m, patch_m, leaf_m};
/// Of one cushion as wide as the patch without the leaves' margin.
constexpr Crown::Size narrow{crown_m, 0.5 * crown_m, leaf_m};
constexpr int picks = 12;  // along each of four axes

std::vector<Crown::Twig> twigs_of(const Crown& crown) {
  std::vector<Crown::Twig> twigs;
  for (int a = 0; a < picks; ++a)
    for (int b = 0; b < picks; ++b)
      for (int c = 0; c < picks; ++c)
        for (int d = 0; d < picks; ++d)
          twigs.push_back(crown.twig((glm::dvec4(a, b, c, d) + 0.5) / double{picks}));
  return twigs;
}

// A leaf of that length at any twig is over the patch.
TEST(Crown, HasItsTwigsOverThePatchUpToItsHeight) {
  const std::vector<Crown::Twig> twigs = twigs_of(Crown(usual, 3, 1));
  float highest_m = 0.0F;
  for (const Crown::Twig& twig : twigs) {
    for (const float along_m : {twig.place_m.x, twig.place_m.y}) {
      EXPECT_GE(along_m, leaf_m - 1e-6);
      EXPECT_LE(along_m, patch_m - leaf_m + 1e-6);
    }
    EXPECT_GE(twig.height_m, 0.0F);
    EXPECT_NEAR(glm::length(twig.outwards), 1.0F, 1e-5F);
    EXPECT_GE(twig.outwards.z, 0.0F);
    highest_m = std::max(highest_m, twig.height_m);
  }
  EXPECT_LE(highest_m, crown_m);
  EXPECT_GT(highest_m, 0.9 * crown_m);
}

// Of what is left within the leaves' margin.
TEST(Crown, ShadesMostOfThePatchAndIsHigherInSomePlaces) {
  constexpr double inner = (patch_m - 2.0 * leaf_m) / patch_m;
  constexpr int side = 12;
  std::vector<float> tops_m(side * side, 0.0F);
  for (const Crown::Twig& twig : twigs_of(Crown(usual, 3, 1))) {
    const glm::ivec2 at(twig.place_m * static_cast<float>(side / patch_m));
    float& top_m = tops_m[static_cast<std::size_t>(at.y * side + at.x)];
    top_m = std::max(top_m, twig.height_m);
  }
  const auto covered = std::ranges::count_if(tops_m, [](float top_m) { return top_m > 0.0F; });
  EXPECT_GT(covered, 0.6 * inner * inner * side * side);
  const auto high =
      std::ranges::count_if(tops_m, [](float top_m) { return top_m > 0.8 * crown_m; });
  EXPECT_GT(high, 0.02 * side * side);
  EXPECT_LT(high, 0.5 * side * side);
}

TEST(Crown, HasNoTwigsInTheMiddleOfACushion) {
  // The first cushion, the highest.
  const Crown crown(narrow, 3, 1);
  for (const double height : {0.3, 0.9}) {
    const Crown::Twig deep = crown.twig({0.0, height, 0.0, 0.0});
    const Crown::Twig shallow = crown.twig({0.0, height, 0.0, 1.0});
    EXPECT_NEAR(deep.height_m * 3.0F, shallow.height_m, 1e-5F);
    EXPECT_NEAR(shallow.height_m, height * crown_m, 1e-5);
  }
}

TEST(Crown, TurnsItsTwigsAwayFromTheMiddle) {
  const Crown crown(narrow, 3, 1);
  const float middle_m = static_cast<float>(0.25 * crown_m);
  for (const double turn : {0.05, 0.3, 0.55, 0.8})
    for (const double height : {0.1, 0.6}) {
      const Crown::Twig twig = crown.twig({0.0, height, turn, 0.5});
      const glm::vec2 away = glm::normalize(twig.place_m - middle_m);
      EXPECT_NEAR(glm::dot(glm::normalize(glm::vec2(twig.outwards)), away), 1.0F, 1e-4F);
    }
}

TEST(Crown, BelongsToASeedAndAVariant) {
  const auto places = [](std::uint64_t seed, int variant) {
    std::vector<float> all;
    for (const Crown::Twig& twig : twigs_of(Crown(usual, seed, variant)))
      all.push_back(twig.place_m.x);
    return all;
  };
  EXPECT_EQ(places(3, 1), places(3, 1));
  EXPECT_NE(places(3, 1), places(3, 2));
  EXPECT_NE(places(3, 1), places(4, 1));
}

TEST(Crown, CarriesTheBladesOfAShrubTurnedOutwards) {
  scene::Plant plant;
  plant.crown_m = crown_m;
  plant.lean_deg = 20.0;
  const std::vector<Blade> blades = scatter_blades(plant, {}, {patch_m, 2000, 3, 1, 0});
  const auto raised =
      std::ranges::count_if(blades, [](const Blade& blade) { return blade.root_height_m > 0.05F; });
  EXPECT_GT(raised, 1500);
  const auto mean_lean = [&](float from_m, float to_m) {
    float sum = 0.0F;
    int count = 0;
    for (const Blade& blade : blades) {
      if (blade.root_height_m < from_m || blade.root_height_m >= to_m) continue;
      sum += blade.lean;
      ++count;
    }
    return sum / static_cast<float>(count);
  };
  const auto crown = static_cast<float>(crown_m);
  EXPECT_LT(mean_lean(0.85F * crown, crown), 0.5F);  // upwards at the top
  EXPECT_GT(mean_lean(0.0F, 0.3F * crown), 0.6F);    // outwards at the sides
  for (const Blade& blade : blades) EXPECT_NEAR(glm::length(blade.heading), 1.0F, 1e-5F);
}

// Twelve leaves stand along each shoot, one length of it and another of two and a half leaves.
TEST(Crown, HasItsLeavesAlongShoots) {
  constexpr int of_shoot = 12, shoots = 200;
  scene::Plant plant;
  plant.crown_m = crown_m;
  plant.height_m = 0.04;
  const std::vector<Blade> blades =
      scatter_blades(plant, {}, {patch_m, of_shoot * shoots, 3, 1, 0});
  const auto root_m = [&](int blade) {
    const Blade& one = blades.at(static_cast<std::size_t>(blade));
    return glm::vec3(one.root_m, one.root_height_m);
  };
  double longest_m = 0.0, between_m = 0.0;
  for (int shoot = 0; shoot < shoots; ++shoot) {
    const int first = shoot * of_shoot;
    const glm::vec3 along = glm::normalize(root_m(first + 1) - root_m(first));
    for (int leaf = 1; leaf < of_shoot; ++leaf) {
      const glm::vec3 from_first = root_m(first + leaf) - root_m(first);
      EXPECT_LT(glm::length(glm::cross(from_first, along)), 2e-3F) << "one line";
      longest_m = std::max(longest_m, double{glm::length(from_first)});
    }
    between_m +=
        double{glm::distance(root_m(first), root_m((first + of_shoot) % (of_shoot * shoots)))} /
        shoots;
  }
  EXPECT_LE(longest_m, 2.5 * plant.height_m + 1e-6);
  EXPECT_GT(longest_m, 2.0 * plant.height_m);
  EXPECT_GT(between_m, 0.25 * patch_m) << "shoots are all over the shrub";
}

// Leaves as long as the crown is high: shoots end within the cushion, and above the ground.
TEST(Crown, HasNoLeavesThatGrowFromBelowTheGroundOrFromBeyondThePatch) {
  scene::Plant plant;
  plant.crown_m = plant.height_m = 0.2;
  const auto side_m = static_cast<float>(patch_m);
  for (const Blade& blade : scatter_blades(plant, {}, {patch_m, 1200, 3, 1, 0})) {
    ASSERT_GE(blade.root_height_m, -1e-6F);
    for (const float along_m : {blade.root_m.x, blade.root_m.y}) {
      ASSERT_GT(along_m, 0.2F * side_m);
      ASSERT_LT(along_m, 0.8F * side_m);
    }
  }
}

}  // namespace
}  // namespace wold::grass
