#include "core/noise.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/elementary.h"
#include "core/ground_map.h"
#include "core/random.h"

namespace wold {
namespace {

using Lattice = glm::i64vec2;

/// Quintic fade and what is left of it: the weight of a corner at distance t in [0, 1].
double corner_weight(double t) { return 1.0 - t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

/// Its derivative.
double corner_weight_slope(double t) { return -30.0 * t * t * (t * (t - 2.0) + 1.0); }

std::int64_t wrapped(std::int64_t i, int period) {
  if (period <= 0 || (i >= 0 && i < period)) return i;  // a division costs more than the rest
  const std::int64_t rest = i % period;
  return rest < 0 ? rest + period : rest;
}

using Directions = std::array<glm::dvec2, 256>;

Directions all_directions() {
  Directions all;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double angle = 2.0 * std::numbers::pi * (static_cast<double>(k) + 0.5) / all.size();
    all[k] = {math::cos(angle), math::sin(angle)};
  }
  return all;
}

/// Unit vectors: as good as any angle, and cheaper than its sine.
const Directions& unit_vectors() {
  static const Directions directions = all_directions();
  return directions;
}

const glm::dvec2& one_of(const Directions& directions, std::uint64_t bits) {
  return directions[bits >> 56];
}

/// What random_bits() of a key of gradient noise has in common for all corners.
std::uint64_t field_of(std::uint64_t key) { return mixed(mixed(key) ^ key_of("gradient")); }

/// What the four corners of a place's square share, by column and by row.
struct Corners {
  glm::dvec2 from[2];    ///< to the place
  glm::dvec2 weight[2];  ///< along each axis
  std::uint64_t column[2], row[2];

  Corners(const glm::dvec2& at, std::uint64_t field, const glm::ivec2& period) {
    const glm::dvec2 low = glm::floor(at);
    from[0] = at - low;
    from[1] = at - low - 1.0;
    for (int i = 0; i < 2; ++i) {
      weight[i] = {corner_weight(std::abs(from[i].x)), corner_weight(std::abs(from[i].y))};
      const Lattice corner(low + static_cast<double>(i));
      column[i] = mixed(field ^ static_cast<std::uint64_t>(wrapped(corner.x, period.x)));
      row[i] = static_cast<std::uint64_t>(wrapped(corner.y, period.y));
    }
  }
};

/// Gradient noise of the field that field_of() has made.
double noise_of(const glm::dvec2& at, std::uint64_t field, const glm::ivec2& period) {
  const Directions& directions = unit_vectors();
  const auto [from, weight, column, row] = Corners(at, field, period);
  double sum = 0.0;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const glm::dvec2& direction = one_of(directions, mixed(column[i] ^ row[j]));
      sum += weight[i].x * weight[j].y * glm::dot(direction, glm::dvec2(from[i].x, from[j].y));
    }
  return sum;
}

/// The point of a cell, in the cell.
glm::dvec2 point_of_cell(const Lattice& cell, std::uint64_t key, const glm::ivec2& period) {
  const std::uint64_t bits =
      random_bits({key, key_of("cell"), static_cast<std::uint64_t>(wrapped(cell.x, period.x)),
                   static_cast<std::uint64_t>(wrapped(cell.y, period.y))});
  return {static_cast<double>(bits >> 32) * 0x1.0p-32,
          static_cast<double>(bits & 0xffffffffU) * 0x1.0p-32};
}

/// The square of the radius of a cell's dome, in cells.
double radius2_of_cell(const Lattice& cell, std::uint64_t key, const glm::ivec2& period,
                       double spread) {
  const double size =
      random_uniform({key, key_of("radius"), static_cast<std::uint64_t>(wrapped(cell.x, period.x)),
                      static_cast<std::uint64_t>(wrapped(cell.y, period.y))});
  return math::exp(spread * (2.0 * size - 1.0));
}

}  // namespace

double gradient_noise(const glm::dvec2& at, std::uint64_t key, int period) {
  return gradient_noise(at, key, glm::ivec2(period));
}

double gradient_noise(const glm::dvec2& at, std::uint64_t key, const glm::ivec2& period) {
  return noise_of(at, field_of(key), period);
}

NoiseSlope gradient_noise_slope(const glm::dvec2& at, std::uint64_t key) {
  const Directions& directions = unit_vectors();
  const auto [from, weight, column, row] = Corners(at, key, glm::ivec2(0));
  glm::dvec2 slope[2];
  for (int i = 0; i < 2; ++i)
    slope[i] = (1.0 - 2.0 * i) * glm::dvec2(corner_weight_slope(std::abs(from[i].x)),
                                            corner_weight_slope(std::abs(from[i].y)));
  NoiseSlope sum;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const glm::dvec2& direction = one_of(directions, mixed(column[i] ^ row[j]));
      const double height = glm::dot(direction, glm::dvec2(from[i].x, from[j].y));
      const double both = weight[i].x * weight[j].y;
      sum.value += both * height;
      sum.gradient += both * direction +
                      height * glm::dvec2(slope[i].x * weight[j].y, weight[i].x * slope[j].y);
    }
  return sum;
}

double cell_noise(const glm::dvec2& at, std::uint64_t key, const glm::ivec2& period) {
  const glm::dvec2 low = glm::floor(at);
  const glm::dvec2 in_cell = at - low;
  double nearest2 = 8.0;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      const glm::dvec2 step(i, j);
      const glm::dvec2 away = step + point_of_cell(Lattice(low + step), key, period) - in_cell;
      nearest2 = std::min(nearest2, glm::dot(away, away));
    }
  return std::sqrt(nearest2);
}

double dome_noise(const glm::dvec2& at, std::uint64_t key, const glm::ivec2& period,
                  double spread) {
  const glm::dvec2 low = glm::floor(at);
  const glm::dvec2 in_cell = at - low;
  double highest = -8.0;
  // Nothing farther is the highest: e^0.75 - 2^2 is lower than e^-0.75 - 2, which the point of the
  // cell itself has.
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i) {
      const glm::dvec2 step(i, j);
      const Lattice cell(low + step);
      const glm::dvec2 away = step + point_of_cell(cell, key, period) - in_cell;
      highest =
          std::max(highest, radius2_of_cell(cell, key, period, spread) - glm::dot(away, away));
    }
  return highest;
}

Fbm::Fbm(std::uint64_t key, int octaves, double hurst, int period) {
  double variance = 0.0;
  for (int octave = 0; octave < octaves; ++octave) {
    const auto drawn = [&](std::string_view what) {
      return RandomKey{key, key_of("octave"), static_cast<std::uint64_t>(octave), key_of(what)};
    };
    const double height = math::exp2(-hurst * octave);
    octaves_.push_back({math::exp2(1.0 * octave), height,
                        glm::dvec2(random_uniform(drawn("x")), random_uniform(drawn("y"))),
                        field_of(random_bits(drawn("field"))), period << octave});
    variance += height * height;
  }
  deviation_ = gradient_noise_deviation * std::sqrt(variance);
}

double Fbm::at(const glm::dvec2& at) const {
  double sum = 0.0;
  for (const Octave& octave : octaves_)
    sum += octave.height *
           noise_of(at * octave.scale + octave.shift, octave.field, glm::ivec2(octave.period));
  return sum / deviation_;
}

ScaleFreeNoise::ScaleFreeNoise(std::uint64_t key, const Sizes& sizes, double hurst, double step_m) {
  double variance = 0.0;
  std::uint64_t index = 0;
  for (double feature_m = sizes.largest_m; feature_m >= sizes.smallest_m;
       feature_m /= 2.0, ++index) {
    const double height = math::exp2(-hurst * static_cast<double>(index));
    variance += height * height;
    const double shown = shown_fraction(feature_m, step_m);
    if (shown <= 0.0) continue;
    const auto unit = [&](std::string_view axis) {
      return random_uniform({key, key_of("octave"), index, key_of(axis)});
    };
    octaves_.push_back({feature_m, shown * height, glm::dvec2(unit("x"), unit("y")),
                        field_of(random_bits({key, key_of("octave"), index, key_of("field")}))});
  }
  for (Octave& octave : octaves_) {
    octave.height /= std::sqrt(variance);
    shown_ += octave.height * octave.height;
    octave.height /= gradient_noise_deviation;
  }
}

double ScaleFreeNoise::at(const glm::dvec2& at_m) const { return at(at_m, 0.0); }

double ScaleFreeNoise::at(const glm::dvec2& at_m, double step_m) const {
  double sum = 0.0;
  for (const Octave& octave : octaves_) {
    const double shown = shown_fraction(octave.feature_m, step_m);
    if (shown <= 0.0) break;
    sum += shown * octave.height *
           noise_of(at_m / octave.feature_m + octave.shift, octave.field, glm::ivec2(0));
  }
  return sum;
}

double ScaleFreeNoise::shown(double step_m) const {
  double variance = 0.0;
  for (const Octave& octave : octaves_) {
    const double deviation =
        shown_fraction(octave.feature_m, step_m) * octave.height * gradient_noise_deviation;
    variance += deviation * deviation;
  }
  return variance;
}

}  // namespace wold
