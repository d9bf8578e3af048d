#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "wind/moment.h"
#include "wind/profile.h"
#include "wind/spectrum.h"

namespace wold::wind {

/// One of the plane waves that gusts are made of, at a height and a moment.
struct GustWave {
  glm::dvec2 per_m;              ///< wave vector on the ground, turns per metre east and north
  double per_s = 0.0;            ///< turns per second at one place
  std::array<double, 3> phase;   ///< turns, of each Component
  std::array<double, 3> height;  ///< of each Component, over the local mean speed
};

/// Turbulence that the mean wind carries along ([Taylor1938]): a sum of plane waves
/// ([Shinozuka1972]) whose amplitudes, wave vectors and phases are keyed, so that it is a closed
/// form of place, height and time.
///
/// At a height z each band of frequencies has the variance that Kaimal's spectrum has there
/// (spectrum.h), the whole along the wind being (intensity U(z))^2. The part of a wave's vector
/// that is square to the wind, k' (to the right and up), has a Cauchy distribution of scale C n /
/// (2 pi U), n the frequency and U the speed at reference_m. Its characteristic function is the
/// root coherence that [Davenport1961] found for two places that are d apart across the wind:
///   exp(-C n d / U), C = 10 ([Simiu1996]: 10 along the vertical; across, 8 to 16 are found).
class Gusts {
 public:
  /// `intensity`: standard deviation of the speed along the wind over its mean.
  Gusts(const Profile& profile, double intensity, std::uint64_t seed);

  /// At a height above the ground, metres. 192 of them, of wave lengths along the wind from 2 km
  /// to 0.5 m; longer ones count with the first.
  std::vector<GustWave> waves(double height_m, const Moment& now) const;

 private:
  struct Mode {
    double low_per_m, high_per_m;  ///< its band, along the wind
    double along_per_m, right_per_m, up_per_m;
    std::array<double, 3> phase;
  };
  Profile profile_;
  double intensity_;
  std::vector<Mode> modes_;
};

/// Velocity of the gusts at a place and a height, along the wind, to its right and up, over the
/// local mean speed.
glm::dvec3 gust_at(const std::vector<GustWave>& waves, const glm::dvec2& place_m);

}  // namespace wold::wind
