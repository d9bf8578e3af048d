#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "landscape/aggregate_appearance.h"
#include "landscape/landscape.h"

namespace wold::meadow {

/// The far look by direction, measured: rays through the volumes, which repeat endlessly.
class PatchAppearance {
 public:
  static constexpr int usual_starts = 16;

  /// The mean of some volumes, read from their files, over starts x starts rays through each.
  /// Throws FileError.
  explicit PatchAppearance(std::span<const landscape::Volume> volumes, int starts = usual_starts);

  /// Seen along a direction of the patch's own space, downwards, of any length: as much longer as
  /// it is than 1, as much less grass stands along the ray.
  landscape::AggregateAppearance along(const glm::dvec3& direction) const;

 private:
  static constexpr int azimuths = 8;
  static constexpr std::array<double, 8> elevations_deg = {2.0,  4.0,  8.0,  15.0,
                                                           25.0, 40.0, 60.0, 90.0};
  /// Azimuth by azimuth, counter-clockwise from x, elevations rising.
  std::array<std::array<landscape::AggregateAppearance, elevations_deg.size()>, azimuths> table_{};
};

/// `fraction` of the way from a to b.
landscape::AggregateAppearance mixed(const landscape::AggregateAppearance& a,
                                     const landscape::AggregateAppearance& b, double fraction);

/// The look with `factor` times as much grass along the ray.
landscape::AggregateAppearance thickened(const landscape::AggregateAppearance& look, double factor);

}  // namespace wold::meadow
