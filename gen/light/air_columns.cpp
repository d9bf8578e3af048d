#include "light/air_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/elementary.h"
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

/// Clamped.
double row_of(double radius_m) {
  return std::min(to_horizon_m(radius_m) / longest_m(), 1.0) * (heights - 1);
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
    sum.background += at.background * step_m;
    sum.ozone += at.ozone * step_m;
  }
  return sum;
}

/// Of light that comes along a way: Snell's law to the first order.
double refraction_rad(double radius_m, double cosine, double length_m) {
  constexpr double refractivity_at_sea_level = 2.77e-4;  // of visible light at 15 degrees Celsius
  constexpr double apart_m = 100.0;
  constexpr int steps = 96;
  const double level_m = radius_m * std::sqrt(1.0 - squared(cosine));
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double from = squared(1.0 * i / steps), to = squared((i + 1.0) / steps);
    const double height_m =
        height_along_m(radius_m - ground_radius_m, cosine, 0.5 * (from + to) * length_m);
    const double fall_per_m =
        (air_at(height_m).molecules - air_at(height_m + apart_m).molecules) / apart_m;
    sum += fall_per_m * level_m / (ground_radius_m + height_m) * (to - from) * length_m;
  }
  return refractivity_at_sea_level * sum;
}

double mixed(double a, double b, double fraction) { return a + (b - a) * fraction; }

AirAmounts mixed(const AirAmounts& a, const AirAmounts& b, double fraction) {
  return {mixed(a.molecules, b.molecules, fraction), mixed(a.aerosol, b.aerosol, fraction),
          mixed(a.background, b.background, fraction), mixed(a.ozone, b.ozone, fraction)};
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

AirColumns::AirColumns() : entries_(std::size_t{heights} * angles) {
  parallel_for(std::size_t{heights}, [&](std::size_t row) {
    const double radius_m = radius_of(static_cast<double>(row) / (heights - 1));
    for (int i = 0; i < angles; ++i) {
      const double length_m = length_of(radius_m, static_cast<double>(i) / (angles - 1));
      const double cosine = cosine_of(radius_m, length_m);
      entries_[row * angles + static_cast<std::size_t>(i)] = {
          summed(radius_m, cosine, length_m), refraction_rad(radius_m, cosine, length_m), cosine,
          1.0};
    }
    add_bending(row);
  });
}

/// Brightness is the sun's size in the sky over that without air: upright, refraction makes it
/// less.
void AirColumns::add_bending(std::size_t row) {
  const std::span<Entry> entries(&entries_[row * angles], angles);
  std::array<double, angles> seen_rad{}, without_rad{};
  for (std::size_t i = 0; i < angles; ++i) {
    seen_rad[i] = math::asin(entries[i].cosine_without_air);
    without_rad[i] = seen_rad[i] - entries[i].refraction_rad;
    entries[i].cosine_without_air = math::sin(without_rad[i]);
  }
  for (std::size_t i = 0; i < angles; ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min<std::size_t>(i + 1, angles - 1);
    entries[i].brightness =
        (seen_rad[before] - seen_rad[after]) / (without_rad[before] - without_rad[after]);
  }
}

const AirColumns::Entry& AirColumns::entry(int row, int column) const {
  return entries_[static_cast<std::size_t>(row) * angles + static_cast<std::size_t>(column)];
}

std::optional<AirAmounts> AirColumns::to_space_m(double height_m, double cosine) const {
  const double radius_m = ground_radius_m + std::clamp(height_m, 0.0, air_top_m);
  if (way_end(radius_m - ground_radius_m, cosine).on_ground) return std::nullopt;
  const double row = row_of(radius_m);
  const double column = step_of(radius_m, to_top_m(radius_m, cosine)) * (angles - 1);
  const int low_row = std::min(static_cast<int>(row), heights - 2);
  const int low_column = std::clamp(static_cast<int>(column), 0, angles - 2);
  const auto along = [&](int of_row) {
    return mixed(entry(of_row, low_column).on_way_m, entry(of_row, low_column + 1).on_way_m,
                 std::clamp(column - low_column, 0.0, 1.0));
  };
  return mixed(along(low_row), along(low_row + 1), row - low_row);
}

/// Between the two of a row's angles that enclose that cosine; the first or the last beyond them.
SunRay AirColumns::sun_ray(int row, double cosine) const {
  const Entry* const first = &entry(row, 0);
  const Entry* const after =
      std::lower_bound(first + 1, first + angles - 1, cosine,
                       [](const Entry& of, double than) { return of.cosine_without_air > than; });
  const Entry& high = *(after - 1);
  const Entry& low = *after;
  const double fraction = std::clamp(
      (high.cosine_without_air - cosine) / (high.cosine_without_air - low.cosine_without_air), 0.0,
      1.0);
  return {mixed(high.on_way_m, low.on_way_m, fraction),
          mixed(high.brightness, low.brightness, fraction)};
}

double AirColumns::lowest_cosine(double height_row) const {
  const int low = std::min(static_cast<int>(height_row), heights - 2);
  return mixed(entry(low, angles - 1).cosine_without_air,
               entry(low + 1, angles - 1).cosine_without_air, height_row - low);
}

std::optional<SunRay> AirColumns::from_sun(double height_m, double cosine) const {
  const double row = row_of(ground_radius_m + std::clamp(height_m, 0.0, air_top_m));
  if (cosine < lowest_cosine(row)) return std::nullopt;
  const int low_row = std::min(static_cast<int>(row), heights - 2);
  const SunRay below = sun_ray(low_row, cosine), above = sun_ray(low_row + 1, cosine);
  return SunRay{mixed(below.on_way_m, above.on_way_m, row - low_row),
                mixed(below.brightness, above.brightness, row - low_row)};
}

double AirColumns::elevation_without_air_rad(double seen_elevation_rad) const {
  const double level_rad = entry(0, angles - 1).refraction_rad;
  if (seen_elevation_rad <= 0.0)
    return 0.5 *
           (seen_elevation_rad - std::sqrt(squared(seen_elevation_rad) + 4.0 * squared(level_rad)));
  const double cosine = math::sin(seen_elevation_rad);
  const double column = step_of(ground_radius_m, to_top_m(ground_radius_m, cosine)) * (angles - 1);
  const int low = std::clamp(static_cast<int>(column), 0, angles - 2);
  return seen_elevation_rad - mixed(entry(0, low).refraction_rad, entry(0, low + 1).refraction_rad,
                                    std::clamp(column - low, 0.0, 1.0));
}

}  // namespace wold::light
