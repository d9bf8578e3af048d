#include "grass/geometry/clumps.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/random.h"
#include "grass/geometry/axis.h"
#include "grass/mechanics/mechanics.h"

namespace wold::grass {
namespace {

/// A hair cannot lie further than it is long; its root takes the rest.
constexpr float longest_reach = 0.95F;

std::vector<glm::vec2> clump_roots(int clumps, double patch_m, std::uint64_t seed, int variant) {
  std::vector<glm::vec2> roots;
  for (int clump = 0; clump < clumps; ++clump) {
    const auto place = [&](const char* axis) {
      const auto number =
          (static_cast<std::uint64_t>(variant) << 32) | static_cast<std::uint64_t>(clump);
      return patch_m * random_uniform({seed, key_of("clump"), number, key_of(axis)});
    };
    roots.emplace_back(place("x"), place("y"));
  }
  return roots;
}

/// From a hair's root to the nearest clump's, over the borders of the patch.
glm::vec2 way_to_clump(const glm::vec2& root_m, const std::vector<glm::vec2>& clumps,
                       float patch_m) {
  glm::vec2 nearest(patch_m);
  for (const glm::vec2& clump : clumps) {
    glm::vec2 way = clump - root_m;
    way -= patch_m * glm::round(way / patch_m);
    if (glm::dot(way, way) < glm::dot(nearest, nearest)) nearest = way;
  }
  return nearest;
}

/// How far the tip comes along the heading with the droop c.
float reach_m(const Blade& hair, float droop) {
  BladePose pose;
  pose.droop = droop;
  return BladeAxis(hair, pose).at(hair.length_m).position_m.x;
}

/// The droop c with which the tip comes this far; reach grows with c.
float droop_to_reach(const Blade& hair, float wanted_m) {
  float low = 0.0F;
  float high = 4.0F / std::sqrt(hair.length_m);
  for (int step = 0; step < 30; ++step) {
    const float middle = (low + high) / 2.0F;
    (reach_m(hair, middle) < wanted_m ? low : high) = middle;
  }
  return low;
}

}  // namespace

void clump(std::vector<Blade>& hairs, const scene::Physiology& physiology, double patch_m,
           std::uint64_t seed, int variant) {
  const scene::Fur& fur = physiology.fur;
  const std::vector<glm::vec2> roots = clump_roots(fur.clumps, patch_m, seed, variant);
  const double comb = radians(fur.comb_deg);
  const glm::vec2 combed(math::sin(comb), math::cos(comb));
  const auto relieved = static_cast<float>(relieved_loss(1.0, physiology.stiffening));
  for (Blade& hair : hairs) {
    const glm::vec2 way = way_to_clump(hair.root_m, roots, static_cast<float>(patch_m)) +
                          combed * (static_cast<float>(fur.lying) * hair.length_m);
    const float distance_m = glm::length(way);
    if (distance_m > 0.0F) hair.heading = way / distance_m;
    const float dry_droop = hair.fresh_droop;
    hair.fresh_droop = droop_to_reach(hair, std::min(distance_m, longest_reach * hair.length_m));
    hair.droop_rate = (dry_droop - hair.fresh_droop) / relieved;
  }
}

}  // namespace wold::grass
