#include "terrain/known_land.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/interpolation.h"
#include "core/parallel.h"

namespace wold::terrain {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A level of the pyramid: square, half as many values along a side as the finer one.
struct Level {
  int side;
  std::vector<double> values;  ///< NaN where nothing is known

  double at(int i, int j) const {
    const int x = std::clamp(i, 0, side - 1), y = std::clamp(j, 0, side - 1);
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                  static_cast<std::size_t>(x)];
  }
  /// Bilinear, by the middles of values; all of them are known.
  double between(double x, double y) const {
    const double left = std::floor(x), low = std::floor(y);
    const int i = static_cast<int>(left), j = static_cast<int>(low);
    return bilinear(at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1), x - left, y - low);
  }
};

/// The mean of what is known in each square of four.
Level coarser(const Level& fine) {
  Level level{(fine.side + 1) / 2, {}};
  for (int j = 0; j < level.side; ++j)
    for (int i = 0; i < level.side; ++i) {
      double sum = 0.0;
      int count = 0;
      for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
        const double value = fine.at(2 * i + di, 2 * j + dj);
        if (std::isnan(value)) continue;
        sum += value;
        ++count;
      }
      level.values.push_back(count > 0 ? sum / count : nothing);
    }
  return level;
}

/// Fills in from a coarser level that has no gaps, and evens out what was filled in: towards the
/// membrane that hangs between what is known (Laplace's equation, by Jacobi's passes).
void fill(Level& fine, const Level& coarse) {
  const int passes = std::clamp(4000 / fine.side, 12, 400);
  std::vector<std::size_t> gaps;
  std::size_t at = 0;
  for (int j = 0; j < fine.side; ++j)
    for (int i = 0; i < fine.side; ++i, ++at)
      if (std::isnan(fine.values[at])) {
        gaps.push_back(at);
        fine.values[at] = coarse.between(0.5 * i - 0.25, 0.5 * j - 0.25);
      }
  std::vector<double> evened(gaps.size());
  for (int pass = 0; pass < passes; ++pass) {
    parallel_for(gaps.size(), [&](std::size_t k) {
      const int i = static_cast<int>(gaps[k]) % fine.side,
                j = static_cast<int>(gaps[k]) / fine.side;
      evened[k] =
          0.25 * (fine.at(i - 1, j) + fine.at(i + 1, j) + fine.at(i, j - 1) + fine.at(i, j + 1));
    });
    for (std::size_t k = 0; k < gaps.size(); ++k) fine.values[gaps[k]] = evened[k];
  }
}

std::vector<double> without_gaps(int side, std::vector<double> values) {
  std::vector<Level> levels = {{side, std::move(values)}};
  while (levels.back().side > 1) levels.push_back(coarser(levels.back()));
  if (std::isnan(levels.back().values.front())) levels.back().values.front() = 0.0;
  for (std::size_t i = levels.size() - 1; i > 0; --i) fill(levels[i - 1], levels[i]);
  return std::move(levels.front().values);
}

/// Distances from what is not NaN, within 8 %, by two passes (Borgefors 1986, Distance
/// transformations in digital images).
GroundMap<double> distances_from_known(const GroundMap<double>& heights_m) {
  const int samples = heights_m.samples();
  const double step_m = heights_m.step_m();
  GroundMap<double> distance_m(samples, heights_m.square(), 4.0 * heights_m.size_m());
  const auto look = [&](int i, int j, int towards) {
    double& here = distance_m.at(i, j);
    if (!std::isnan(heights_m.at(i, j))) here = 0.0;
    for (const auto& [di, dj] : {std::pair(1, 0), {-1, 1}, {0, 1}, {1, 1}}) {
      const int x = i + towards * di, y = j + towards * dj;
      if (x < 0 || y < 0 || x >= samples || y >= samples) continue;
      const double way_m = di * dj == 0 ? step_m : std::numbers::sqrt2 * step_m;
      here = std::min(here, distance_m.at(x, y) + way_m);
    }
  };
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) look(i, j, -1);
  for (int j = samples - 1; j >= 0; --j)
    for (int i = samples - 1; i >= 0; --i) look(i, j, 1);
  return distance_m;
}

}  // namespace

KnownLand filled_in(GroundMap<double> heights_m) {
  GroundMap<double> distance_m = distances_from_known(heights_m);
  heights_m.values() = without_gaps(heights_m.samples(), std::move(heights_m.values()));
  return {std::move(heights_m), std::move(distance_m)};
}

}  // namespace wold::terrain
