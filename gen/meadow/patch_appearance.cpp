#include "meadow/patch_appearance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "landscape/tiled_volume.h"

namespace wold::meadow {
namespace {

using std::numbers::pi;

/// The mean over starts x starts rays that begin evenly over the patch, each at another fraction of
/// a step.
landscape::AggregateAppearance mean_look(const landscape::TiledVolume& volume,
                                         const glm::dvec3& direction, int starts) {
  landscape::AggregateAppearance mean{glm::dvec3(0.0), 0.0};
  for (int j = 0; j < starts; ++j)
    for (int i = 0; i < starts; ++i) {
      const double begin = ((7 * i + 5 * j) % starts + 0.5) / starts;
      const landscape::AggregateAppearance look =
          volume.trace({(glm::dvec2(i, j) + 0.5) / static_cast<double>(starts), direction, begin});
      mean.radiance += look.radiance / (1.0 * starts * starts);
      mean.transmittance += look.transmittance / (starts * starts);
    }
  return mean;
}

}  // namespace

PatchAppearance::PatchAppearance(std::span<const landscape::Volume> volumes, int starts) {
  for (auto& row : table_) row.fill({glm::dvec3(0.0), 0.0});
  for (const landscape::Volume& description : volumes) {
    const landscape::TiledVolume volume(description);
    const double fraction = 1.0 / static_cast<double>(volumes.size());
    parallel_for(azimuths * elevations_deg.size(), [&](std::size_t k) {
      const std::size_t a = k / elevations_deg.size();
      const std::size_t e = k % elevations_deg.size();
      const double azimuth = 2.0 * pi * static_cast<double>(a) / azimuths;
      const double elevation = radians(elevations_deg[e]);
      const landscape::AggregateAppearance look =
          mean_look(volume,
                    {math::cos(azimuth) * math::cos(elevation),
                     math::sin(azimuth) * math::cos(elevation), -math::sin(elevation)},
                    starts);
      table_[a][e].radiance += look.radiance * fraction;
      table_[a][e].transmittance += look.transmittance * fraction;
    });
  }
}

landscape::AggregateAppearance PatchAppearance::along(const glm::dvec3& direction) const {
  const double elevation_deg =
      std::clamp(degrees(math::atan2(-direction.z, glm::length(glm::dvec2(direction)))),
                 elevations_deg.front(), elevations_deg.back());
  const auto above =
      std::upper_bound(elevations_deg.begin() + 1, elevations_deg.end() - 1, elevation_deg);
  const auto e = static_cast<std::size_t>(above - elevations_deg.begin());
  const double up =
      (elevation_deg - elevations_deg[e - 1]) / (elevations_deg[e] - elevations_deg[e - 1]);
  const double turns = math::atan2(direction.y, direction.x) / (2.0 * pi);
  const double place = (turns - std::floor(turns)) * azimuths;
  const auto a = static_cast<std::size_t>(place) % azimuths;
  const auto look = [&](std::size_t azimuth) {
    return mixed(table_[azimuth % azimuths][e - 1], table_[azimuth % azimuths][e], up);
  };
  return thickened(mixed(look(a), look(a + 1), place - std::floor(place)),
                   1.0 / glm::length(direction));
}

landscape::AggregateAppearance mixed(const landscape::AggregateAppearance& a,
                                     const landscape::AggregateAppearance& b, double fraction) {
  return {glm::mix(a.radiance, b.radiance, fraction),
          std::lerp(a.transmittance, b.transmittance, fraction)};
}

landscape::AggregateAppearance thickened(const landscape::AggregateAppearance& look,
                                         double factor) {
  const double transmittance = math::pow(look.transmittance, factor);
  const double cover = 1.0 - look.transmittance;
  return {cover > 0.0 ? look.radiance * ((1.0 - transmittance) / cover) : look.radiance,
          transmittance};
}

}  // namespace wold::meadow
