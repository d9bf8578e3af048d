#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/noise.h"
#include "wind/air_flow.h"
#include "wind/gusts.h"
#include "wind/moment.h"

namespace wold::snow {

/// Wind 10 m above level snow, m/s, that begins to lift it, by the air's temperature in degrees
/// Celsius ([Li1997]): 7 to 9.4 for dry snow, least at -27 degrees; 9.9 for snow that is wet.
double lifting_wind_m_s(double temperature_c);

/// Friction velocity, m/s, of a wind 10 m above snow that it drives along ([Pomeroy1990]): what
/// leaps makes the ground the rougher, the stronger the wind.
double friction_over_blowing_snow_m_s(double wind_m_s);

/// Mass of suspended snow in a volume of air, kg/m^3, in steady wind over a wide field
/// ([Pomeroy1992]). `friction_m_s` is the wind's friction velocity, `lifting_m_s` the one that
/// begins to lift snow; below that nothing is suspended, and all that the law has from a tenth more
/// on. Below the height of the leaping grains, 0.084 u*^1.27 m, it is what it is there.
double suspended_kg_m3(double height_m, double friction_m_s, double lifting_m_s);

/// Extinction of a kilogram of snow grains per m^3 at a height above the ground, m^2/kg
/// ([Pomeroy1988]): grains of mean radius 46 um z^-0.258, the fewer large ones the higher, each of
/// which takes twice its cross-section from a beam of light.
double grain_extinction_m2_per_kg(double height_m);

/// Mean cosine of the angle by which blown grains scatter light ([Raisanen2015]).
inline constexpr double grain_asymmetry = 0.78;

/// Up to where snow is blown over fields as wide as a scene's, metres: some 5 m after 300 m of open
/// snow ([Pomeroy1992]).
inline constexpr double blown_depth_m = 5.0;

/// Snow that the wind of one moment carries over the ground, as if loose snow lay everywhere. Gusts
/// and hills make places stormier than others. On the ground it goes in streamers, longer than wide
/// and drawn along by the wind, which become a haze above. A closed form of place and time.
class BlowingSnow {
 public:
  /// `air`: the wind over the snow; has to outlive it. `step_m`: distance between the places that
  /// are asked for; streamers that are too small for it count with their mean.
  BlowingSnow(const wind::AirFlow& air, const wind::Moment& now, double temperature_c,
              std::uint64_t seed, double step_m);

  /// What the wind lifts at one place on the ground, by gusts and hills.
  struct Lift {
    double factor = 0.0;     ///< of suspended_kg_m3(), what does not depend on the height; kg/m^3
    double leaping_m = 0.0;  ///< height of the leaping grains
  };
  Lift lift(const glm::dvec2& place_m) const;

  /// How much thicker than on average a streamer is on the ground: deviations of ln extinction.
  double streamer(const glm::dvec2& place_m) const;

  /// Where what is at a place and a height above it has been lifted: streamers lean forward, as
  /// eddies in the wind do.
  glm::dvec2 foot_m(const glm::dvec2& place_m, double height_m) const;

  /// Extinction at a height above the snow, by what was lifted at its foot and the streamer there,
  /// 1/m; none from blown_depth_m on.
  double extinction_per_m(const Lift& foot, double streamer, double height_m) const;

 private:
  /// What of the extinction depends on the height alone.
  struct Height {
    double ln_m2_per_kg = 0.0;  ///< of what multiplies Lift::factor
    double deviation = 0.0;     ///< of ln extinction between streamers
  };
  static std::vector<Height> heights();
  Height at(double height_m) const;

  const wind::AirFlow& air_;
  wind::Moment now_;
  double lifting_friction_m_s_;
  wind::Axes axes_;
  std::vector<wind::GustWave> gusts_;
  ScaleFreeNoise slow_, fast_;
  std::vector<Height> heights_;  ///< at even steps of the root of the height
};

}  // namespace wold::snow
