#include "terrain/broken_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/random.h"

namespace wold::terrain {
namespace {

constexpr std::uint64_t field = 5;

template <int dims>
using Place = glm::vec<dims, double>;

/// In the middle of a region four units wide.
template <int dims>
Place<dims> random_place(std::uint64_t number) {
  Place<dims> place;
  for (int axis = 0; axis < dims; ++axis)
    place[axis] = 1.0 + 2.0 * random_uniform({1, number, static_cast<std::uint64_t>(axis), 0});
  return place;
}

/// The points of all blocks that have a part in the region, each met from many places.
template <int dims>
std::vector<Place<dims>> all_points() {
  constexpr std::uint64_t places = dims == 2 ? 20000 : 200000;
  std::map<std::uint64_t, Place<dims>> points;
  for (std::uint64_t number = 0; number < places; ++number) {
    const Place<dims> place = 2.0 * random_place<dims>(number) - 2.0;
    const Block<dims> block = block_at<dims>(place, field);
    points.emplace(block.bits, place + block.middle_away);
  }
  std::vector<Place<dims>> all;
  for (const auto& [bits, point] : points) all.push_back(point);
  return all;
}

/// Each block is the nearest of all points, and its joint half way to the next one.
template <int dims>
void expect_the_nearest() {
  const std::vector<Place<dims>> points = all_points<dims>();
  for (std::uint64_t number = 0; number < 2000; ++number) {
    const Place<dims> place = random_place<dims>(1000000 + number);
    std::vector<Place<dims>> nearest(2);
    std::ranges::partial_sort_copy(
        points, nearest, {}, [&](const auto& point) { return glm::distance(point, place); },
        [&](const auto& point) { return glm::distance(point, place); });
    const Block<dims> block = block_at<dims>(place, field);
    EXPECT_LT(glm::distance(place + block.middle_away, nearest[0]), 1e-9);
    const Place<dims> across = glm::normalize(nearest[1] - nearest[0]);
    EXPECT_NEAR(block.joint, glm::dot(0.5 * (nearest[0] + nearest[1]) - place, across), 1e-9);
  }
}

TEST(BrokenSurface, BlocksAreThoseOfTheNearestPointsOfAPlane) { expect_the_nearest<2>(); }

TEST(BrokenSurface, BlocksAreThoseOfTheNearestPointsInSpace) { expect_the_nearest<3>(); }

}  // namespace
}  // namespace wold::terrain
