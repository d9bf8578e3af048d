#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "wind/moment.h"
#include "wind/profile.h"

namespace wold::wind {

/// One of the waves of a canopy, at a moment.
struct CanopyWave {
  glm::dvec2 per_m;     ///< wave vector on the ground, turns per metre east and north
  double per_s = 0.0;   ///< turns per second at one place
  double phase = 0.0;   ///< turns
  double height = 0.0;  ///< over the mean speed at the canopy's top, along the wind
};

/// Honami: the eddies that the shear at a canopy's top rolls up, which waves of grass follow.
///
/// By the analogy with a mixing layer they are 8.1 shear lengths apart along the wind, 7 to 10
/// measured ([Raupach1996]), and travel at 1.8 times the mean speed at the canopy's top
/// ([Finnigan1979], [Finnigan2000]). Their wave lengths scatter by a fifth, so that waves come in
/// groups, and their crests are two to three wave lengths wide (modelling choices). Together with
/// the gusts from above, the wind at the top has the standard deviation of half the mean that is
/// measured there, in air as rough as the neutral surface layer (u_*/U by the Profile, 2.15 u_*);
/// less in smoother air.
class Honami {
 public:
  Honami(const Profile& profile, double intensity, std::uint64_t seed);

  /// At the canopy's top, 16 of them.
  std::vector<CanopyWave> waves(const Moment& now) const;

  double wave_length_m() const { return wave_length_m_; }
  /// How much of them is left at a height above the ground: they fade as waves of their length do
  /// on either side of the layer that they are of.
  double left_at(double height_m) const;
  /// How fast they travel, over the speed at reference_m.
  double travel() const { return travel_; }

 private:
  struct Mode {
    double along_per_m, right_per_m, phase;
  };
  Profile profile_;
  double wave_length_m_, travel_, height_;
  std::vector<Mode> modes_;
};

}  // namespace wold::wind
