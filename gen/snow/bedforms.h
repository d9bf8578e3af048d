#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/noise.h"
#include "snow/weather.h"
#include "wind/moment.h"

namespace wold::snow {

/// How far wind has shaped the surface of the snow at a height above the terrain's zero: 0 smooth,
/// 1 as far as it can. Wind from 6.4 m/s on shapes it while it is cold ([Kochanski2019]), within
/// some hours; snow that falls buries what was there, and thaw levels it. How fast are modelling
/// choices.
/// `lain`: whether snow lies when the weather begins; the winds of its winter have shaped that.
double shaped_by_wind(const Weather& weather, double time_s, double height_m, bool lain);

/// Where the wind blows to that shapes snow, degrees clockwise from north: the mean wind's until
/// the film begins, so that forms stay where they are.
double shaping_heading_deg(const Weather& weather);

/// What wind carves into snow, a keyed function of the place: sastrugi, ridges along the wind, a
/// decimetre high, steep against it; long waves across it; ripples a hand wide ([Kochanski2019]);
/// and a crust that is rough by millimetres. Sastrugi prevail in some places, ripples in others.
/// Sizes were read off photographs, and looked at.
class Bedforms {
 public:
  /// `heading_deg`: where the wind blows to, clockwise from north.
  Bedforms(double heading_deg, std::uint64_t seed);

  /// Whether a map with that step shows any.
  static bool is_shown(double step_m);

  /// Steepest ascent of a surface that the wind has shaped as far as it can, as a map with that
  /// step shows it.
  glm::dvec2 ascent(const glm::dvec2& at_m, double step_m) const;

 private:
  struct Octave {
    glm::dvec2 feature_m;  ///< along the wind and across it
    double height_m;       ///< standard deviation
    glm::dvec2 shift;
    std::uint64_t key;
  };
  using Form = std::vector<Octave>;
  static Form octaves(std::uint64_t key, const glm::dvec2& largest_m, double height_m, int count);
  static NoiseSlope relief(const Form& form, const glm::dvec2& wind_m, double step_m);
  static glm::dvec2 ridges(const Form& form, const glm::dvec2& wind_m, double step_m);

  wind::Axes axes_;
  Form sastrugi_, waves_, ripples_, crust_;
  Fbm carved_, rippled_;  ///< where there are sastrugi and ripples
};

}  // namespace wold::snow
