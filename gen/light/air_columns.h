#pragma once

#include <optional>
#include <vector>

#include "light/air.h"

namespace wold::light {

/// The earth's radius, metres.
inline constexpr double ground_radius_m = 6.36e6;
/// Height above the ground, metres, where the air ends.
inline constexpr double air_top_m = 8.0e4;

/// Height above the ground, metres, after `length_m` of a straight way from a height at a zenith
/// angle of that cosine.
double height_along_m(double height_m, double cosine, double length_m);

/// How much air lies on straight ways out into space, tabulated (within 0.5 %).
class AirColumns {
 public:
  AirColumns();

  /// Amounts in metres from a height in [0, air_top_m], which is clamped, at a zenith angle of that
  /// cosine; nothing where the ground is in the way.
  std::optional<AirAmounts> to_space_m(double height_m, double cosine) const;

 private:
  std::vector<AirAmounts> values_;  ///< zenith angles of one height after the other
};

/// Where a way from a height at a zenith angle of that cosine ends: at the ground or in space.
struct WayEnd {
  double length_m;
  bool on_ground;
};
WayEnd way_end(double height_m, double cosine);

}  // namespace wold::light
