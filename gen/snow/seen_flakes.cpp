#include "snow/seen_flakes.h"

#include <algorithm>
#include <bit>

#include "core/parallel_sort.h"

namespace wold::snow {

void FlakeCuller::see_chosen(const FlakeLanes& flakes, Chosen chosen,
                             std::vector<SeenFlake>& seen) const {
  const glm::dvec3& eye_m = frustum_.eye_m();
  std::size_t above = 0;
  for (std::size_t n = 0; n < chosen.count; ++n) {
    const std::uint8_t i = chosen.lane[n];
    const glm::dvec3 centre_m = eye_m + glm::dvec3(flakes.from_eye.at(i));
    chosen.lane[above] = i;
    above += centre_m.z > static_cast<double>(ground_.sample(centre_m.x, centre_m.y)) ? 1 : 0;
  }
  chosen.count = above;
  const std::size_t before = seen.size();
  seen.resize(before + chosen.count);
  look_.see(flakes, chosen, seen.data() + before);
}

void FlakeCollector::add(const Tornado& tornado, double time_s, const FlakeLook& look,
                         const Frustum& frustum, const Heightfield& ground) {
  const glm::dvec2 foot_m = tornado.foot_m(time_s);
  const auto ground_m = static_cast<double>(ground.sample(foot_m.x, foot_m.y));
  const FlakeCuller culler(look, frustum, ground);
  std::vector<Range> parts;
  split(0, 0, tornado.flakes(), parts);
  add(parts.size(), [&](std::size_t part, std::vector<SeenFlake>& seen) {
    FlakeLanes flakes = {};
    for (std::uint64_t first = parts[part].first; first < parts[part].last; first += lanes) {
      const std::size_t count = std::min<std::uint64_t>(lanes, parts[part].last - first);
      for (std::size_t i = 0; i < count; ++i)
        flakes.set(i, tornado.flake(first + i, time_s, ground_m), frustum.eye_m());
      culler.see(
          flakes, count, [](std::size_t) { return true; }, seen);
    }
  });
}

std::vector<SeenFlake> FlakeCollector::farthest_first(const glm::dvec3& eye_m) const {
  std::vector<const SeenFlake*> flakes;
  for (const std::vector<SeenFlake>& part : parts_)
    for (const SeenFlake& flake : part) flakes.push_back(&flake);
  // The bits of a positive float rise with it; flakes as far as each other keep their order.
  std::vector<std::uint64_t> order(flakes.size());
  for (std::size_t i = 0; i < flakes.size(); ++i) {
    const glm::vec3 away = flakes[i]->centre_m - glm::vec3(eye_m);
    const std::uint32_t nearness = ~std::bit_cast<std::uint32_t>(glm::dot(away, away));
    order[i] = static_cast<std::uint64_t>(nearness) << 32 | i;
  }
  parallel_sort(order);
  std::vector<SeenFlake> sorted(flakes.size());
  parallel_for_blocks(sorted.size(), [&](std::size_t i) {
    sorted[i] = *flakes[static_cast<std::uint32_t>(order[i])];
  });
  return sorted;
}

void split(std::size_t of, std::uint64_t first, std::uint64_t last, std::vector<Range>& parts) {
  constexpr std::uint64_t max = 128 * lanes;
  for (; first < last; first += max) parts.push_back({of, first, std::min(last, first + max)});
}

}  // namespace wold::snow
