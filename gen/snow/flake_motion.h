#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "snow/flake_look.h"
#include "snow/flake_sizes.h"
#include "snow/weather.h"
#include "snow/wind_field.h"

namespace wold::snow {

/// A cube whose content repeats itself throughout the world.
struct PeriodicCube {
  glm::dvec3 centre_m{0.0};  ///< of the repetition that one looks at
  double side_m = 1.0;
};

/// Where keyed flakes are at any time: a closed form, no frame needs another. A flake's place is
/// its keyed start in the cube, less its fall, plus the way of the wind, its own gusts and its
/// sway.
class FlakeMotion {
 public:
  /// `rate_mm_h`: see FlakeSizes.
  FlakeMotion(const scene::Scene& scene, const Weather& weather, double rate_mm_h);

  /// What all flakes share at a time.
  struct Moment {
    double time_s = 0.0;                  ///< since the first frame
    std::vector<float> diameters_m = {};  ///< see FlakeSizes
    Motion common = {};
    WindField::Moment gusts = {};
  };
  /// rate_mm_h > 0: what falls there and then.
  Moment moment(double time_s, double rate_mm_h) const;

  /// A flake before its own gusts and sway, which are costly and take it less than
  /// farthest_own_way_m() away.
  struct Drifting {
    glm::dvec3 place_m{0.0};  ///< in the cube
    FlakeSizes::Body body = {};
    std::uint64_t key = 0;
  };
  Drifting drifting(std::uint64_t population_key, std::uint64_t index, const Moment& moment,
                    const PeriodicCube& cube) const;
  Flake flake(const Drifting& drifting, const Moment& moment) const;

  double farthest_own_way_m() const;

 private:
  WindField wind_;
  FlakeSizes sizes_;
};

}  // namespace wold::snow
