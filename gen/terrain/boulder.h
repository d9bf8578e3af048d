#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace wold::terrain {

/// A block of rock that lies in the ground: an ellipsoid cut by flat faces with worn edges. What
/// stands out of the ground is a height over it, so that vertical and overhanging sides are left
/// out. World space; lengths are in metres, heights above the ground that it lies in.
class Boulder {
 public:
  /// `bits`: keyed random bits, its shape.
  Boulder(const glm::dvec2& middle_m, double width_m, std::uint64_t bits);

  const glm::dvec2& middle_m() const { return middle_m_; }
  /// Its longest diameter, but for corners.
  double width_m() const { return width_m_; }
  /// Nothing of a boulder of a width is farther from its middle.
  static double reach_m(double width_m) { return 0.72 * width_m; }
  /// Nothing of a boulder of a width is higher over the ground.
  static double most_height_m(double width_m) { return 0.75 * width_m; }

  struct Top {
    double height_m = -1.0;    ///< below 0 beside the boulder
    glm::dvec2 gradient{0.0};  ///< its steepest ascent
  };
  Top top(const glm::dvec2& at_m) const;

  /// Where the boulder ends, from its middle towards `way`, a unit vector; metres.
  double rim_m(const glm::dvec2& way) const;

  /// Shares of the sun's and of the sky's light, in [0, 1], that the boulder leaves to the ground
  /// beside it, as an ellipsoid would. `to_sun`: unit vector; `ascent`: the ground's gradient;
  /// `snow_m`: how deep snow lies on the ground.
  struct Light {
    double sun = 1.0;
    double sky = 1.0;
  };
  Light light_beside(const glm::dvec2& at_m, const glm::dvec3& to_sun, const glm::dvec2& ascent,
                     double snow_m = 0.0) const;

 private:
  /// A plane over the ground, in the boulder's own axes.
  struct Face {
    double height_m;  ///< over the boulder's middle
    glm::dvec2 gradient;
  };
  static constexpr int faces_above = 5, faces_beside = 6;

  glm::dvec2 to_own(const glm::dvec2& way) const;

  glm::dvec2 middle_m_;
  double width_m_;
  glm::dvec2 along_;       ///< its longest axis, a unit vector
  glm::dvec3 half_m_;      ///< semi-axes
  double raised_m_ = 0.0;  ///< how high its middle lies above the ground
  std::array<Face, faces_above + faces_beside> faces_;
};

}  // namespace wold::terrain
