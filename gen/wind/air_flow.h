#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "wind/gusts.h"
#include "wind/honami.h"
#include "wind/moment.h"
#include "wind/profile.h"
#include "wind/speed_up.h"

namespace wold::wind {

/// The wind over a piece of ground with grass on it. Nothing in it changes with time: whoever asks
/// says the moment.
class AirFlow {
 public:
  /// `canopy_m`: the grass's height. `intensity`: standard deviation of the wind along its way over
  /// its mean, at any height; 0 is a steady wind without waves of the canopy.
  AirFlow(const Heightfield& terrain, double canopy_m, double intensity, std::uint64_t seed);

  /// East, north and up, m/s, at a place and a height above the ground, metres from 0. Up is square
  /// to the ground.
  glm::dvec3 velocity_m_s(const glm::dvec2& place_m, double height_m, const Moment& now) const;

  const Profile& profile() const { return profile_; }
  const SpeedUp& speed_up() const { return speed_up_; }
  const Gusts& gusts() const { return gusts_; }
  const Honami& honami() const { return honami_; }

 private:
  Profile profile_;
  SpeedUp speed_up_;
  Gusts gusts_;
  Honami honami_;
};

}  // namespace wold::wind
