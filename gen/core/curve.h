#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace wold {

/// A smooth curve through control points: piecewise cubic, once differentiable, monotone wherever
/// the points are, so it never overshoots them (Fritsch and Carlson 1980, Monotone piecewise cubic
/// interpolation, SIAM Journal on Numerical Analysis 17:238).
class Curve {
 public:
  /// Points are (x, y) with x strictly rising. Throws InputError when there are fewer than two, x
  /// does not rise or a number is not finite.
  explicit Curve(std::vector<glm::dvec2> points);

  /// The value at x; outside the points the nearest end's value.
  double operator()(double x) const;

  const std::vector<glm::dvec2>& points() const { return points_; }

 private:
  std::vector<glm::dvec2> points_;
  std::vector<double> slopes_;  ///< dy/dx at each point
};

}  // namespace wold
