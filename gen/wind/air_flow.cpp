#include "wind/air_flow.h"

#include <numbers>

#include "core/elementary.h"

namespace wold::wind {
namespace {

/// Of all waves together, along the wind, over the mean speed at the canopy's top.
double canopy_waves_at(const std::vector<CanopyWave>& waves, const glm::dvec2& place_m) {
  double sum = 0.0;
  for (const CanopyWave& wave : waves)
    sum += wave.height *
           math::cos(2.0 * std::numbers::pi * (glm::dot(wave.per_m, place_m) + wave.phase));
  return sum;
}

}  // namespace

AirFlow::AirFlow(const Heightfield& terrain, double canopy_m, double intensity, std::uint64_t seed)
    : profile_(canopy_m),
      speed_up_(terrain, profile_),
      gusts_(profile_, intensity, seed),
      honami_(profile_, intensity, seed) {}

glm::dvec3 AirFlow::velocity_m_s(const glm::dvec2& place_m, double height_m,
                                 const Moment& now) const {
  const double mean_m_s = now.speed_m_s * profile_.at(height_m);
  const Axes axes(now.heading_deg);
  const glm::dvec2 mean = mean_m_s * speed_up_.mean(place_m, axes.along, height_m);
  const glm::dvec3 gust = gust_at(gusts_.waves(height_m, now), place_m);
  const double waving = honami_.left_at(height_m) * canopy_waves_at(honami_.waves(now), place_m);
  const glm::dvec2 level =
      (1.0 + gust.x) * (1.0 + waving) * mean + gust.y * glm::dvec2(mean.y, -mean.x);
  return {level, gust.z * glm::length(mean)};
}

}  // namespace wold::wind
