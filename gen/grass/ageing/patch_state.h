#pragma once

#include <cmath>
#include <compare>
#include <string>

namespace wold::grass {

/// Steps in which snow on blades grows from none to all they can carry: patches are made for each.
/// Thin snow whitens fast, so that even steps of the square root of the fraction look even.
inline constexpr int snow_levels = 8;

/// What a patch of grass looks like: how far it has withered, how much snow lies on its blades, and
/// which of the film's lights it stands in.
struct PatchState {
  int key_frame = 0;  ///< index into scene::key_frames()
  int snow = 0;       ///< level, 0 to snow_levels
  int light = 0;      ///< index into the lights that texels are baked for

  PatchState(int of_key_frame, int of_snow = 0, int of_light = 0)
      : key_frame(of_key_frame), snow(of_snow), light(of_light) {}

  /// Fraction of the snow the blades can carry.
  double snow_fraction() const {
    return static_cast<double>(snow * snow) / (snow_levels * snow_levels);
  }
  /// Where a fraction in [0, 1] lies among the levels.
  static double level_of(double snow_fraction) { return snow_levels * std::sqrt(snow_fraction); }
  /// The same grass, whatever light it stands in.
  PatchState unlit() const { return {key_frame, snow}; }
  /// For file names: "k03", under snow "k03_s2", in another light than the first "k03_s2_l1".
  std::string name() const;

  auto operator<=>(const PatchState&) const = default;
};

}  // namespace wold::grass
