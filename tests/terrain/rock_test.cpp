#include "terrain/rock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"
#include "core/statistics.h"

namespace wold::terrain {
namespace {

const glm::dvec3 to_sun = glm::normalize(glm::dvec3(-0.6, -0.5, 0.6));

/// Means over `count` keyed places of 8 km: beds are up to 200 m thick.
template <class Value>
double mean(int count, const Value& value) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto along = [i](const char* axis) {
      return 8000.0 * random_uniform({3, 0, static_cast<std::uint64_t>(i), key_of(axis)});
    };
    sum += value(glm::dvec3(along("x"), along("y"), along("z")));
  }
  return sum / count;
}

TEST(Rock, HasItsAlbedoOnTheMeanHoweverFine) {
  for (const double slope_deg : {-50.0, -30.0, 0.0, 50.0, 70.0})
    for (const double step_m : {0.02, 0.3, 1.0, 10.0})
      for (const double sun_deg : {10.0, 37.0}) {
        const double slope = slope_deg * 0.0174533, sun = sun_deg * 0.0174533;
        const glm::dvec3 up(0.0, -std::sin(slope), std::cos(slope));
        const glm::dvec3 to(-0.6 * std::cos(sun), -0.8 * std::cos(sun), std::sin(sun));
        const Rock rock(glm::vec3(0.2F), 5, step_m);
        const double albedo = mean(
            4000, [&](const glm::dvec3& place_m) { return double{rock.at(place_m, up, to).g}; });
        EXPECT_NEAR(albedo, 0.2, 0.012)
            << slope_deg << " degrees, " << step_m << " m, sun " << sun_deg << " degrees";
      }
}

TEST(Rock, DebrisHasTheRocksAlbedoOnTheMeanHoweverFine) {
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.0, -0.6, 1.0));
  for (const double step_m : {0.02, 0.3, 1.0, 10.0}) {
    const Rock rock(glm::vec3(0.2F), 5, step_m);
    const double albedo = mean(4000, [&](const glm::dvec3& place_m) {
      return double{rock.debris_at(place_m, up, to_sun).g};
    });
    EXPECT_NEAR(albedo, 0.2, 0.012) << step_m << " m";
  }
}

// Stones of a metre at most: what is farther apart is another stone.
TEST(Rock, DebrisIsBrokenSmall) {
  const Rock rock(glm::vec3(1.0F), 5, 0.02);
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.0, -0.6, 1.0));
  const auto change = [&](double way_m) {
    return mean(3000, [&](const glm::dvec3& place_m) {
      return std::abs(double{rock.debris_at(place_m + glm::dvec3(way_m, 0.0, 0.0), up, to_sun).g} -
                      double{rock.debris_at(place_m, up, to_sun).g});
    });
  };
  const double far = change(300.0);
  EXPECT_GT(far, 0.2);
  EXPECT_NEAR(change(4.0), far, 0.1 * far);
  EXPECT_LT(change(0.004), 0.5 * far);
}

TEST(Rock, FacesTurnToTheSunAndAway) {
  const Rock rock(glm::vec3(1.0F), 5, 0.02);
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.0, -1.0, 0.7));
  const auto fraction = [&](double from, double to) {
    return mean(4000, [&](const glm::dvec3& place_m) {
      const double shade{rock.at(place_m, up, to_sun).g};
      return shade > from && shade <= to ? 1.0 : 0.0;
    });
  };
  EXPECT_GT(fraction(1.2, 2.7), 0.1);
  EXPECT_GT(fraction(0.0, 0.8), 0.1);
  EXPECT_EQ(fraction(0.07, 2.7), 1.0);
}

// No sun shines on it at dusk, wherever that went.
TEST(Rock, IsLitFromAboveWhenTheSunHasSet) {
  const Rock rock(glm::vec3(1.0F), 5, 0.02);
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.0, -1.0, 0.7));
  const auto set = [](double x) { return glm::normalize(glm::dvec3(x, 0.0, -0.05)); };
  const auto difference = [&](const glm::dvec3& a, const glm::dvec3& b) {
    return mean(500, [&](const glm::dvec3& place_m) {
      return std::abs(double{rock.at(place_m, up, a).g} - double{rock.at(place_m, up, b).g});
    });
  };
  EXPECT_EQ(difference(set(1.0), set(-1.0)), 0.0);
  EXPECT_GT(difference(glm::normalize(glm::dvec3(1.0, 0.0, 0.2)),
                       glm::normalize(glm::dvec3(-1.0, 0.0, 0.2))),
            0.05);
}

// Beds lie nearly level: means along a wall differ from height to height, by what blocks do not.
TEST(Rock, BedsShowOnWallsFromAfar) {
  const Rock rock(glm::vec3(0.2F), 5, /*step_m=*/5.0);
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.0, -1.0, 0.3));
  constexpr int heights = 150, places = 40;
  double sum = 0.0, squares = 0.0;
  for (int height = 0; height < heights; ++height) {
    double at_height = 0.0;
    for (int place = 0; place < places; ++place)
      at_height += double{rock.at({3.0 * place, 0.0, 4.0 * height}, up, to_sun).g} / places;
    sum += at_height / heights;
    squares += at_height * at_height / heights;
  }
  EXPECT_GT(std::sqrt(squares - sum * sum), 0.2 * sum);
}

// A map's plan would be drawn out on a wall: nothing would change upwards.
TEST(Rock, HasBlocksOnAWall) {
  const Rock rock(glm::vec3(1.0F), 5, 0.02);
  const glm::dvec3 up(0.0, -1.0, 0.0);
  const auto change = [&](const glm::dvec3& way_m) {
    return mean(2000, [&](const glm::dvec3& place_m) {
      return std::abs(double{rock.at(place_m + way_m, up, to_sun).g} -
                      double{rock.at(place_m, up, to_sun).g});
    });
  };
  const double aside = change({0.05, 0.0, 0.0}), upwards = change({0.0, 0.0, 0.05});
  EXPECT_GT(upwards, aside);  // beds are flat
  EXPECT_LT(upwards, 3.0 * aside);
  EXPECT_LT(aside, 0.5 * change({5.0, 0.0, 0.0}));
}

// On a wall, places of a map are farther apart than on level ground. Detail finer than that would
// be a streak up the wall.
TEST(Rock, EvensOutOnWallsWhatIsFinerThanTheWayUpThem) {
  const glm::dvec3 wall(0.0, -std::sin(1.3614), std::cos(1.3614)), level(0.0, 0.0, 1.0);
  const auto deviation = [](double step_m, const glm::dvec3& up) {
    const Rock rock(glm::vec3(0.2F), 5, step_m);
    return mean(500, [&](const glm::dvec3& place_m) {
      return std::abs(double{rock.at(place_m, up, to_sun).g} - 0.2);
    });
  };
  EXPECT_LT(deviation(150.0, wall), 1e-6);
  EXPECT_GT(deviation(150.0, level), 0.02);
}

TEST(BrokenSurface, APlaceOnSteepGroundIsFarFromTheNext) {
  const auto step_on_slope = [](double slope_deg) {
    const double slope = slope_deg * 0.0174532925;
    return slope_step_m({0.0, -std::sin(slope), std::cos(slope)}, 3.0);
  };
  EXPECT_EQ(step_on_slope(0.0), 3.0);
  EXPECT_NEAR(step_on_slope(60.0), 6.0, 1e-6);
  EXPECT_NEAR(step_on_slope(90.0), 15.0, 1e-6);
}

// Ledges hold snow: nearly all of gentle rock, half of what is as steep as snow holds, little of a
// wall; as much on coarse maps as on fine ones.
TEST(Rock, HoldsSnowOnItsLedgesHoweverFine) {
  constexpr double steepest_deg = 56.0;
  for (const double step_m : {0.05, 1.0, 10.0, 100.0}) {
    SCOPED_TRACE(step_m);
    const Rock rock(glm::vec3(1.0F), 5, step_m);
    const auto share = [&](double slope_deg) {
      const double slope = slope_deg * 0.0174533;
      return mean(3000, [&](const glm::dvec3& place_m) {
        return rock.ledges(place_m, {0.0, -std::sin(slope), std::cos(slope)}, steepest_deg);
      });
    };
    EXPECT_GT(share(30.0), 0.93);
    EXPECT_NEAR(share(45.0), 0.79, 0.03);
    EXPECT_NEAR(share(steepest_deg), 0.5, 0.06);
    EXPECT_LT(share(80.0), 0.1);
  }
}

// Each ledge is white or bare where a map is fine enough to show it.
TEST(Rock, LedgesHaveEdgesOnFineMaps) {
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.0, -1.5, 1.0));
  const auto between = [&](double step_m) {
    const Rock rock(glm::vec3(1.0F), 5, step_m);
    return mean(2000, [&](const glm::dvec3& place_m) {
      const double share = rock.ledges(place_m, up, 56.0);
      return share > 0.1 && share < 0.9 ? 1.0 : 0.0;
    });
  };
  EXPECT_LT(between(0.05), 0.25);
  EXPECT_GT(between(100.0), 0.8);
}

// Snow on walls marks their beds: pale ones stand steeper than dark ones.
TEST(Rock, LedgesFollowBeds) {
  const Rock rock(glm::vec3(0.2F), 5, /*step_m=*/5.0);
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.0, -1.5, 1.0));
  constexpr int heights = 400, places = 40;
  std::vector<float> pale(heights), held(heights);
  for (std::size_t height = 0; height < heights; ++height)
    for (int place = 0; place < places; ++place) {
      const glm::dvec3 place_m(3.0 * place, 0.0, 10.0 * static_cast<double>(height));
      pale[height] += rock.at(place_m, up, to_sun).g / places;
      held[height] += static_cast<float>(rock.ledges(place_m, up, 56.0) / places);
    }
  const double mean_pale = wold::mean(pale), mean_held = wold::mean(held);
  double both = 0.0, of_pale = 0.0, of_held = 0.0;
  for (std::size_t height = 0; height < heights; ++height) {
    both += (pale[height] - mean_pale) * (held[height] - mean_held);
    of_pale += (pale[height] - mean_pale) * (pale[height] - mean_pale);
    of_held += (held[height] - mean_held) * (held[height] - mean_held);
  }
  EXPECT_LT(both / std::sqrt(of_pale * of_held), -0.3);
}

}  // namespace
}  // namespace wold::terrain
