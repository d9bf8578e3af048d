#include "cloud/relief.h"

#include <algorithm>

#include "cloud/box_filter.h"

namespace wold::cloud {
namespace {

constexpr int heights = 4;

LayerMap shrunk(const PeriodicMap<float>& map, int factor) {
  LayerMap small(std::max(map.width() / factor, 1), std::max(map.height() / factor, 1));
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < small.width(); ++x)
      small.at(x, y) = static_cast<std::uint16_t>(
          map.sample((x + 0.5) / small.width(), (y + 0.5) / small.height()));
  return small;
}

}  // namespace

LayerMap relief_ranks(const LayerMap& ranks, double pixel_m, double thickness_m) {
  const double thickness_px = thickness_m / pixel_m;
  PeriodicMap<float> values(ranks.width(), ranks.height());
  std::ranges::copy(ranks.values(), values.values().begin());
  const int factor = tops_radius_px(thickness_px, std::min(ranks.width(), ranks.height()));
  return shrunk(smoothed_for_tops(values, thickness_px), std::max(1, factor));
}

std::vector<LayerMap> relief_light(const LayerMap& relief_ranks, const std::vector<float>& height_m,
                                   const Droplets& droplets, const glm::dvec3& sun_direction,
                                   double coarse_m) {
  std::vector<LayerMap> light;
  light.reserve(heights);
  for (int i = 0; i < heights; ++i)
    light.push_back(sunlit(relief_ranks, height_m, droplets, sun_direction, coarse_m,
                           i * double{height_m.back()} / heights));
  return light;
}

}  // namespace wold::cloud
