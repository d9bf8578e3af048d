#include "snow/seen_flakes.h"

#include <tbb/parallel_sort.h>

namespace wold::snow {
namespace {

/// Where a flake is among the parts, in the order of its distance.
struct Place {
  float nearness;  ///< rises towards the eye
  std::uint32_t part, index;

  bool operator<(const Place& other) const {
    if (nearness != other.nearness) return nearness < other.nearness;
    return part != other.part ? part < other.part : index < other.index;
  }
};

}  // namespace

bool is_in_view(const Flake& flake, const Frustum& frustum, const Heightfield& ground) {
  return glm::distance(flake.centre_m, frustum.eye_m()) > nearest_flake_m &&
         frustum.touches(flake.centre_m, flake.diameter_m) &&
         flake.centre_m.z > static_cast<double>(ground.sample(flake.centre_m.x, flake.centre_m.y));
}

void Gathering::add(const Tornado& tornado, double time_s, const FlakeLook& look,
                    const Frustum& frustum, const Heightfield& ground) {
  const glm::dvec2 foot_m = tornado.foot_m(time_s);
  const auto ground_m = static_cast<double>(ground.sample(foot_m.x, foot_m.y));
  add(tornado.flakes(), [&](std::uint64_t i, std::vector<SeenFlake>& seen) {
    const Flake flake = tornado.flake(i, time_s, ground_m);
    if (is_in_view(flake, frustum, ground)) seen.push_back(look.seen(flake));
  });
}

std::vector<SeenFlake> Gathering::farthest_first(const glm::dvec3& eye_m) const {
  std::vector<Place> places;
  for (std::uint32_t part = 0; part < parts_.size(); ++part)
    for (std::uint32_t i = 0; i < parts_[part].size(); ++i) {
      const glm::vec3 away = parts_[part][i].centre_m - glm::vec3(eye_m);
      places.push_back({-glm::dot(away, away), part, i});
    }
  tbb::parallel_sort(places.begin(), places.end());
  std::vector<SeenFlake> sorted(places.size());
  parallel_for_blocks(places.size(),
                      [&](std::size_t i) { sorted[i] = parts_[places[i].part][places[i].index]; });
  return sorted;
}

}  // namespace wold::snow
