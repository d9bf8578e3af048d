#include "light/air_columns.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace wold::light {
namespace {

constexpr double top_radius_m = ground_radius_m + air_top_m;
constexpr int heights = 48, angles = 128;

double squared(double x) { return x * x; }

/// From the horizon as seen at the ground to the place where the way leaves the air.
double longest_m() { return std::sqrt(squared(top_radius_m) - squared(ground_radius_m)); }

/// From a place to where a way grazes the ground, 0 on the ground.
double to_horizon_m(double radius_m) {
  return std::sqrt(std::max(squared(radius_m) - squared(ground_radius_m), 0.0));
}

double to_top_m(double radius_m, double cosine) {
  const double inside = squared(radius_m) * (squared(cosine) - 1.0) + squared(top_radius_m);
  return std::max(std::sqrt(std::max(inside, 0.0)) - radius_m * cosine, 0.0);
}

/// The table's axes (Bruneton and Neyret 2008, section 4): heights by the way to the horizon,
/// angles by the way to the top, both of which are where the amounts change.
double radius_of(double step) {
  return std::sqrt(squared(step * longest_m()) + squared(ground_radius_m));
}

double length_of(double radius_m, double step) {
  const double least = top_radius_m - radius_m, most = to_horizon_m(radius_m) + longest_m();
  return least + step * (most - least);
}

double step_of(double radius_m, double length_m) {
  const double least = top_radius_m - radius_m, most = to_horizon_m(radius_m) + longest_m();
  return most > least ? (length_m - least) / (most - least) : 0.0;
}

double cosine_of(double radius_m, double length_m) {
  if (length_m <= 0.0) return 1.0;
  const double cosine =
      (squared(top_radius_m) - squared(radius_m) - squared(length_m)) / (2.0 * radius_m * length_m);
  return std::clamp(cosine, -1.0, 1.0);
}

/// By the midpoint rule over steps that grow with the square of their number, as the air thins.
AirAmounts summed(double radius_m, double cosine, double length_m) {
  constexpr int steps = 96;
  AirAmounts sum;
  for (int i = 0; i < steps; ++i) {
    const double from = squared(1.0 * i / steps), to = squared((i + 1.0) / steps);
    const AirAmounts at =
        air_at(height_along_m(radius_m - ground_radius_m, cosine, 0.5 * (from + to) * length_m));
    const double step_m = (to - from) * length_m;
    sum.molecules += at.molecules * step_m;
    sum.aerosol += at.aerosol * step_m;
    sum.ozone += at.ozone * step_m;
  }
  return sum;
}

AirAmounts mixed(const AirAmounts& a, const AirAmounts& b, double fraction) {
  return {std::lerp(a.molecules, b.molecules, fraction), std::lerp(a.aerosol, b.aerosol, fraction),
          std::lerp(a.ozone, b.ozone, fraction)};
}

}  // namespace

double height_along_m(double height_m, double cosine, double length_m) {
  const double radius_m = ground_radius_m + height_m;
  const double here = squared(radius_m) + squared(length_m) + 2.0 * radius_m * cosine * length_m;
  return std::max(std::sqrt(here) - ground_radius_m, 0.0);
}

WayEnd way_end(double height_m, double cosine) {
  const double radius_m = ground_radius_m + height_m;
  const double inside = squared(radius_m) * (squared(cosine) - 1.0) + squared(ground_radius_m);
  if (cosine < 0.0 && inside > 0.0)
    return {std::max(-radius_m * cosine - std::sqrt(inside), 0.0), true};
  return {to_top_m(radius_m, cosine), false};
}

AirColumns::AirColumns() : values_(std::size_t{heights} * angles) {
  parallel_for(std::size_t{heights}, [&](std::size_t row) {
    const double radius_m = radius_of(static_cast<double>(row) / (heights - 1));
    for (int i = 0; i < angles; ++i) {
      const double length_m = length_of(radius_m, static_cast<double>(i) / (angles - 1));
      values_[row * angles + static_cast<std::size_t>(i)] =
          summed(radius_m, cosine_of(radius_m, length_m), length_m);
    }
  });
}

std::optional<AirAmounts> AirColumns::to_space_m(double height_m, double cosine) const {
  const double radius_m = ground_radius_m + std::clamp(height_m, 0.0, air_top_m);
  if (way_end(radius_m - ground_radius_m, cosine).on_ground) return std::nullopt;
  const double row = to_horizon_m(radius_m) / longest_m() * (heights - 1);
  const double column = step_of(radius_m, to_top_m(radius_m, cosine)) * (angles - 1);
  const int low_row = std::clamp(static_cast<int>(row), 0, heights - 2);
  const int low_column = std::clamp(static_cast<int>(column), 0, angles - 2);
  const auto at = [&](int of_row, int of_column) {
    return values_[static_cast<std::size_t>(of_row) * angles + static_cast<std::size_t>(of_column)];
  };
  const auto along = [&](int of_row) {
    return mixed(at(of_row, low_column), at(of_row, low_column + 1),
                 std::clamp(column - low_column, 0.0, 1.0));
  };
  return mixed(along(low_row), along(low_row + 1), std::clamp(row - low_row, 0.0, 1.0));
}

}  // namespace wold::light
