#include "cloud/relief.h"

#include <algorithm>
#include <cmath>

#include "cloud/box_filter.h"

namespace wold::cloud {
namespace {

constexpr int heights = 4;

/// Of the thickness, of one of two box filters: single columns would stand out of a cloud like
/// needles.
constexpr double smooth_radius = 0.08;

PeriodicMap<float> smoothed(const LayerMap& ranks, int radius_px) {
  PeriodicMap<float> values(ranks.width(), ranks.height());
  std::ranges::copy(ranks.values(), values.values().begin());
  return box_filtered(box_filtered(values, radius_px), radius_px);
}

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
  const double radius_px = smooth_radius * thickness_m / pixel_m;
  const int most_px = (std::min(ranks.width(), ranks.height()) - 1) / 2;
  const int rounded_px = static_cast<int>(std::lround(radius_px));
  return shrunk(smoothed(ranks, std::min(rounded_px, most_px)), std::max(1, rounded_px));
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
