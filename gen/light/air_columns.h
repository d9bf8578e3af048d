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

/// How the sun's light comes to a place through air that bends it.
struct SunRay {
  AirAmounts on_way_m;
  double brightness;  ///< over that without air: what is bent differs and spreads
};

/// How much air lies on straight ways out into space, and how it bends light there, tabulated
/// (within 0.5 %).
class AirColumns {
 public:
  AirColumns();

  /// Amounts in metres from a height in [0, air_top_m], which is clamped, at a zenith angle of that
  /// cosine; nothing where the ground is in the way.
  std::optional<AirAmounts> to_space_m(double height_m, double cosine) const;

  /// The sun's light at a height, which is clamped as above, where the sun would stand at a zenith
  /// angle of that cosine without air; nothing where the ground is in the way. Refraction is that
  /// along a straight way: at the horizon 31 minutes of arc, of 34 along the bent one.
  std::optional<SunRay> from_sun(double height_m, double cosine) const;

  /// Where the sun would stand without air that is seen at an elevation from sea level. Below the
  /// horizon as scene::sun_position() has it: the lower the less refraction.
  double elevation_without_air_rad(double seen_elevation_rad) const;

 private:
  struct Entry {
    AirAmounts on_way_m;
    double refraction_rad;
    double cosine_without_air, brightness;
  };
  void add_bending(std::size_t row);
  const Entry& entry(int row, int column) const;
  SunRay sun_ray(int row, double cosine) const;
  double lowest_cosine(double height_row) const;

  std::vector<Entry> entries_;  ///< zenith angles of one height after the other
};

/// Where a way from a height at a zenith angle of that cosine ends: at the ground or in space.
struct WayEnd {
  double length_m;
  bool on_ground;
};
WayEnd way_end(double height_m, double cosine);

}  // namespace wold::light
