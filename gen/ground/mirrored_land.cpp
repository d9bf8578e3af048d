#include "ground/mirrored_land.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "ground/line_of_sight.h"
#include "light/daylight.h"

namespace wold::ground {
namespace {

/// Of the ground, or of the water that stands on it.
double height_on(const Heightfield& ground, const terrain::Water& water, const glm::dvec2& at_m) {
  return water.share(at_m, 1.0) > 0.5 ? water.level_m(at_m) : double{ground.sample(at_m.x, at_m.y)};
}

}  // namespace

MirroredLand::MirroredLand(const terrain::Surroundings& land, const Heightfield& ground,
                           const terrain::Water& water, const glm::dvec3& eye_m,
                           const Panorama& panorama)
    : eye_m_(eye_m),
      panorama_(panorama),
      lines_(static_cast<std::size_t>(2.0 * panorama.half_rad / panorama.step_rad) + 2) {
  parallel_for(lines_.size(), [&](std::size_t i) {
    lines_[i] =
        line(land, ground, water,
             panorama.middle_rad - panorama.half_rad + panorama.step_rad * static_cast<double>(i));
  });
}

std::vector<MirroredLand::Height> MirroredLand::line(const terrain::Surroundings& land,
                                                     const Heightfield& ground,
                                                     const terrain::Water& water,
                                                     double azimuth) const {
  constexpr double spacing = 0.004, farthest_m = 60e3;
  const glm::dvec2 towards(light::direction_of(azimuth, 0.0));
  const double border_m = to_border_m(land.square(), glm::dvec2(eye_m_), towards);
  const double end_m = border_m + std::min(land.reach_m(), farthest_m);
  std::vector<Height> heights;
  for (double distance_m = 0.5 * ground.step_m(); distance_m < end_m;) {
    const glm::dvec2 at_m = glm::dvec2(eye_m_) + towards * distance_m;
    const bool is_inside = distance_m < border_m;
    const double height_m = is_inside ? height_on(ground, water, at_m)
                                      : land.height_m(at_m) - drop_m(distance_m) + drop_m(border_m);
    heights.push_back({static_cast<float>(distance_m), static_cast<float>(height_m)});
    const double step_m = is_inside ? 0.5 * ground.step_m() : 0.7 * land.step_m(at_m);
    distance_m += std::max(step_m, spacing * distance_m);
  }
  return heights;
}

std::vector<std::optional<glm::dvec2>> MirroredLand::met(const glm::dvec3& from_m,
                                                         const std::vector<double>& rises) const {
  std::vector<std::optional<glm::dvec2>> places(rises.size());
  const glm::dvec2 way_m = glm::dvec2(from_m) - glm::dvec2(eye_m_);
  const double begin_m = glm::length(way_m);
  if (begin_m <= 0.0) return places;
  const glm::dvec2 towards = way_m / begin_m;
  const double place =
      std::round((turned_rad(azimuth_rad(glm::dvec3(way_m, 0.0)) - panorama_.middle_rad) +
                  panorama_.half_rad) /
                 panorama_.step_rad);
  const auto& line = lines_[static_cast<std::size_t>(
      std::clamp(place, 0.0, static_cast<double>(lines_.size() - 1)))];
  auto before =
      std::ranges::upper_bound(line, static_cast<float>(begin_m), {}, &Height::distance_m);
  double met_m = begin_m, rise_before = -1.0;
  std::size_t next = 0;
  for (auto height = before; height != line.end() && next < rises.size(); ++height) {
    const double distance_m{height->distance_m};
    const double rise =
        (double{height->height_m} - from_m.z) / std::max(distance_m - begin_m, 1e-3);
    for (; next < rises.size() && rises[next] <= rise; ++next) {
      const double part =
          std::clamp((rises[next] - rise_before) / std::max(rise - rise_before, 1e-12), 0.0, 1.0);
      places[next] = glm::dvec2(eye_m_) + towards * std::lerp(met_m, distance_m, part);
    }
    met_m = distance_m;
    rise_before = rise;
  }
  return places;
}

}  // namespace wold::ground
