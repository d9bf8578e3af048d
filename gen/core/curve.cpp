#include "core/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/elementary.h"
#include "core/error.h"

namespace wold {
namespace {

void check(const std::vector<glm::dvec2>& points) {
  if (points.size() < 2)
    throw InputError(fmt::format("a curve needs at least 2 points, got {}", points.size()));
  for (const glm::dvec2& point : points)
    if (!std::isfinite(point.x) || !std::isfinite(point.y))
      throw InputError("a curve's points must be finite numbers");
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i].x > points[i - 1].x))
      throw InputError(fmt::format("a curve's points must have rising x, got {} after {}",
                                   points[i].x, points[i - 1].x));
}

std::vector<double> secants(const std::vector<glm::dvec2>& points) {
  std::vector<double> slopes;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const glm::dvec2 step = points[i] - points[i - 1];
    slopes.push_back(step.y / step.x);
  }
  return slopes;
}

/// Means of the neighbouring secants, flat at a turning point.
std::vector<double> first_slopes(const std::vector<double>& secant) {
  std::vector<double> slopes = {secant.front()};
  for (std::size_t i = 1; i < secant.size(); ++i)
    slopes.push_back(secant[i - 1] * secant[i] > 0.0 ? 0.5 * (secant[i - 1] + secant[i]) : 0.0);
  slopes.push_back(secant.back());
  return slopes;
}

/// Pulls the two slopes of a piece into the circle of radius 3 around 0, in units of its secant:
/// there the cubic is monotone (Fritsch and Carlson 1980, section 4).
void limit(double secant, double& left, double& right) {
  if (secant == 0.0) {
    left = right = 0.0;
    return;
  }
  const double length = math::hypot(left, right) / std::abs(secant);
  if (length <= 3.0) return;
  left *= 3.0 / length;
  right *= 3.0 / length;
}

}  // namespace

Curve::Curve(std::vector<glm::dvec2> points) : points_(std::move(points)) {
  check(points_);
  const std::vector<double> secant = secants(points_);
  slopes_ = first_slopes(secant);
  for (std::size_t i = 0; i < secant.size(); ++i) limit(secant[i], slopes_[i], slopes_[i + 1]);
}

double Curve::operator()(double x) const {
  if (x <= points_.front().x) return points_.front().y;
  if (x >= points_.back().x) return points_.back().y;
  const auto right =
      std::upper_bound(points_.begin(), points_.end(), x,
                       [](double value, const glm::dvec2& p) { return value < p.x; });
  const auto i = static_cast<std::size_t>(right - points_.begin()) - 1;
  const double width = points_[i + 1].x - points_[i].x;
  const double t = (x - points_[i].x) / width;
  // Hermite's cubic, written from the chord: a straight piece has no rounding of its own.
  const double rise = points_[i + 1].y - points_[i].y;
  return points_[i].y + t * rise +
         t * (1.0 - t) *
             ((1.0 - t) * (width * slopes_[i] - rise) - t * (width * slopes_[i + 1] - rise));
}

}  // namespace wold
