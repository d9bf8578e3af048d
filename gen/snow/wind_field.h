#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "snow/simd_lanes.h"
#include "snow/weather.h"
#include "wind/air_flow.h"

namespace wold::snow {

/// A displacement and its rate.
struct Motion {
  glm::dvec3 way_m{0.0};
  glm::dvec3 velocity_m_s{0.0};
};

/// What carries a flake besides its fall, as a closed form of time: no frame needs another.
///
/// The mean wind has come a way s since the weather began; turbulence is carried along with it
/// (Taylor 1938, The spectrum of turbulence), so that a flake meets gusts at points of that way:
/// each is a sum of sines A cos(2 pi s / l + phase) of displacement, whose velocities have the
/// standard deviation turbulence times the wind's speed, along both axes, and half of it upwards.
/// Long ones, of 6 to 90 m, are common to all flakes about the eye; each flake has short ones, of
/// 1.5 and 4 m, of its own, a quarter of the variance: neighbours agree by 0.75.
///
/// Where the scene's air is given, the long ones are its gusts at the eye, ten metres up: a gust
/// that bends the grass before the camera takes the flakes along.
class WindField {
 public:
  /// turbulence 0: steady. `air`: that of grass that waves, or nullptr.
  WindField(const Weather& weather, double turbulence, std::uint64_t key,
            std::shared_ptr<const wind::AirFlow> air = nullptr);

  /// The mean wind and the gusts that all flakes feel; those of the air are a place's, on the
  /// ground.
  Motion common(double time_s, const glm::dvec2& place_m = glm::dvec2(0.0)) const;

  /// What own gusts need to know of a moment.
  struct Moment {
    std::array<float, 2> phases;  ///< of the own gusts, in turns
    float speed_m_s = 0.0F;
  };
  Moment moment(double time_s) const;

  /// A flake's own gusts; `bits` are 64 random ones of its own.
  struct Gust {
    glm::vec3 way_m;
    glm::vec3 velocity_m_s;
  };
  Gust own_gust(const Moment& moment, std::uint64_t bits) const;
  /// The same of many flakes, added to what they have.
  void add_own_gusts(const Moment& moment, const Lanes<std::uint64_t>& bits, VectorLanes& way_m,
                     VectorLanes& velocity_m_s) const;
  /// No flake's own gusts displace it farther.
  double farthest_own_gust_m() const;

 private:
  static constexpr std::size_t common_waves = 6;
  static constexpr std::size_t own_waves = 6;  ///< of each length one along each axis
  /// One of a flake's own waves at a moment.
  struct OwnWave {
    float phase;  ///< common to all flakes, in turns
    float way_m, velocity_m_s;
    std::size_t half;  ///< of the flake's bits, and the first one in it
    int first_bit;
  };
  OwnWave own_wave(const Moment& moment, std::size_t wave) const;

  struct Wave {
    double per_m;  ///< turns
    double phase;
  };
  void add_own_common(double run_m, double speed_m_s, Motion& motion) const;
  void add_gusts_of_air(const wind::Moment& now, const glm::dvec2& place_m, Motion& motion) const;

  Weather weather_;
  std::shared_ptr<const wind::AirFlow> air_;
  double turbulence_;
  glm::vec3 own_heights_;  ///< of own gusts' sines, over the wind's speed, by axis
  std::array<std::array<Wave, common_waves>, 3> common_;  ///< by axis
};

}  // namespace wold::snow
