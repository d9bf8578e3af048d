#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "wind/profile.h"

namespace wold::wind {

/// L of waves of the ground, metres: a quarter of the wave length ([Hunt1988]).
double quarter_wave_m(double radians_per_m);

/// Depth l of the layer next to the ground in which friction counts, metres:
///   l ln(l / z0) = 2 kappa^2 L ([Jackson1975]); z0 is the roughness, L > z0.
double inner_layer_m(double hill_m, double roughness_m);

/// What hills make of the mean wind near the ground, by linear theory ([Jackson1975]): the pressure
/// of the potential flow over the ground, which is that of the speed at the height L, drives the
/// slower air of the inner layer. For each wave k of the ground z, and a unit vector e along the
/// undisturbed wind,
///   du / U(l) = e (k . e) k / |k| z(k) (ln(L / z0) / ln(l / z0))^2.
/// It is linear in e, so that one map, a symmetric matrix per place, holds for all winds: speed-up
/// on crests, shelter at feet and in hollows, ways round hills and along valleys. In Fourier space,
/// over the ground mirrored at its borders, on 128 x 128 places. Waves shorter than some 10 z0 are
/// left out. It knows no separated flow: lees are as sheltered as windward feet.
class SpeedUp {
 public:
  SpeedUp(const Heightfield& terrain, const Profile& profile);

  /// The mean wind near the ground over that above level ground, as a vector east and north, at a
  /// place; `along` is a unit vector. The speed along it is from 0.1 to 2:
  /// a change d becomes tanh(d) or, where wind is lost, 0.9 tanh(d / 0.9).
  glm::dvec2 mean(const glm::dvec2& place_m, const glm::dvec2& along) const;
  /// The same at a height above the ground, metres: the change fades as exp(-3 z / L)
  /// ([Taylor1984]), L being the ground's own.
  glm::dvec2 mean(const glm::dvec2& place_m, const glm::dvec2& along, double height_m) const;

  /// L of the ground as a whole: that of its mean wave number, waves weighted by what they do to
  /// the wind.
  double hill_m() const { return hill_m_; }

 private:
  glm::dvec2 change(const glm::dvec2& place_m, const glm::dvec2& along) const;

  FactorMap east_, north_, mixed_;  ///< entries of the matrix
  double hill_m_ = 1.0;
};

}  // namespace wold::wind
