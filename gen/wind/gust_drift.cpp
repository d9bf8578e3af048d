#include "wind/gust_drift.h"

#include <numbers>

#include "core/elementary.h"

namespace wold::wind {

GustDrift gust_drift(const Gusts& gusts, const glm::dvec2& place_m, double height_m,
                     double shortest_m, const Moment& now) {
  constexpr double two_pi = 2.0 * std::numbers::pi;
  const Axes axes(now.heading_deg);
  // Along the wind, to its right and up.
  glm::dvec3 way_m(0.0), over_mean(0.0);
  for (const GustWave& wave : gusts.waves(height_m, now)) {
    const double along_per_m = glm::dot(wave.per_m, axes.along);
    if (along_per_m * shortest_m > 1.0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      // At one place a wave's phase falls as the wind runs on.
      const double phase = two_pi * (glm::dot(wave.per_m, place_m) + wave.phase[i]);
      const auto axis = static_cast<glm::length_t>(i);
      way_m[axis] -= wave.height[i] / (two_pi * along_per_m) * math::sin(phase);
      over_mean[axis] += wave.height[i] * math::cos(phase);
    }
  }
  const auto in_world = [&](const glm::dvec3& v) {
    return glm::dvec3(axes.on_ground(glm::dvec2(v)), v.z);
  };
  return {in_world(way_m), now.speed_m_s * in_world(over_mean)};
}

}  // namespace wold::wind
