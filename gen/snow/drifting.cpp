#include "snow/drifting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/elementary.h"
#include "core/statistics.h"

namespace wold::snow {
namespace {

constexpr int half_window_deg = 15, ray_step_deg = 5;

/// A point of a ray: in samples from the place that looks, with the weights of the four samples
/// around it. The same for all places.
struct Look {
  int i, j;  ///< of the south-western of the four
  float south_west, south_east, north_west, north_east;
  float per_m;  ///< of distance
};

Look look_at(const glm::dvec2& to_samples, double step_m) {
  const glm::dvec2 low = glm::floor(to_samples);
  const glm::dvec2 fraction = to_samples - low;
  return {static_cast<int>(low.x),
          static_cast<int>(low.y),
          static_cast<float>((1.0 - fraction.x) * (1.0 - fraction.y)),
          static_cast<float>(fraction.x * (1.0 - fraction.y)),
          static_cast<float>((1.0 - fraction.x) * fraction.y),
          static_cast<float>(fraction.x * fraction.y),
          static_cast<float>(1.0 / (glm::length(to_samples) * step_m))};
}

/// Distances along a ray in samples: at least one, at most `max`.
std::vector<double> distances(double max) {
  std::vector<double> result;
  for (double d = 1.0; result.empty() || d <= max; d += std::max(1.0, std::floor(d / 8.0)))
    result.push_back(d);
  return result;
}

std::vector<Look> looks(const Heightfield& terrain, double heading_deg) {
  const double max = std::min(farthest_shelter_m / terrain.step_m(), terrain.samples() - 1.0);
  std::vector<Look> result;
  for (int off = -half_window_deg; off <= half_window_deg; off += ray_step_deg) {
    const double azimuth = glm::radians(heading_deg + 180.0 + off);
    // Whole directions stay on the grid's lines: a remainder of 1e-16 would look a column further.
    const auto rounded = [](double x) { return std::round(x * 1e9) * 1e-9; };
    const glm::dvec2 upwind(rounded(math::sin(azimuth)), rounded(math::cos(azimuth)));
    for (double distance : distances(max))
      result.push_back(look_at(upwind * distance, terrain.step_m()));
  }
  return result;
}

/// Raises the row's steepest rises, as tangents, by what each place sees at `look`.
void raise(std::vector<float>& steepest, const Heightfield& terrain, int j, const Look& look) {
  const int side = terrain.samples();
  const bool is_between_columns = look.south_east != 0.0F || look.north_east != 0.0F;
  const bool is_between_rows = look.north_west != 0.0F || look.north_east != 0.0F;
  const int row = j + look.j;
  if (row < 0 || row + (is_between_rows ? 1 : 0) >= side) return;
  const int first = std::max(0, -look.i);
  const int last = std::min(side, side - look.i - (is_between_columns ? 1 : 0));
  const float* const here = &terrain.at(0, j);
  const float* const south = &terrain.at(0, row) + look.i;
  const float* const north = is_between_rows ? south + side : south;
  const int east = is_between_columns ? 1 : 0;
  for (int i = first; i < last; ++i) {
    const float height_m = look.south_west * south[i] + look.south_east * south[i + east] +
                           look.north_west * north[i] + look.north_east * north[i + east];
    steepest[i] = std::max(steepest[i], (height_m - here[i]) * look.per_m);
  }
}

float degrees_of(float tangent) {
  return std::isfinite(tangent) ? glm::degrees(math::atan(tangent)) : 0.0F;
}

}  // namespace

FactorMap shelter_deg(const Heightfield& terrain, double heading_deg) {
  const std::vector<Look> rays = looks(terrain, heading_deg);
  FactorMap result(terrain.samples(), terrain.size_m());
  parallel_for(static_cast<std::size_t>(terrain.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    std::vector<float> steepest(static_cast<std::size_t>(terrain.samples()),
                                -std::numeric_limits<float>::infinity());
    for (const Look& look : rays) raise(steepest, terrain, j, look);
    std::transform(steepest.begin(), steepest.end(), &result.at(0, j), degrees_of);
  });
  return result;
}

double drift_weight(double shelter_deg, double drifting) {
  constexpr double scale_deg = 15.0;
  return 1.0 + drifting * math::tanh(shelter_deg / scale_deg);
}

FactorMap drift_weights(const Heightfield& terrain, double heading_deg, double drifting) {
  FactorMap weights = shelter_deg(terrain, heading_deg);
  std::vector<float>& values = weights.values();
  parallel_for_blocks(values.size(), [&](std::size_t i) {
    values[i] = static_cast<float>(drift_weight(values[i], drifting));
  });
  return weights;
}

FactorMap drift_factor(const Heightfield& terrain, double heading_deg, double drifting) {
  FactorMap factor = drift_weights(terrain, heading_deg, drifting);
  std::vector<float>& values = factor.values();
  const double average = mean(values);
  if (average > 0.0)
    for (float& value : values) value = static_cast<float>(value / average);
  return factor;
}

int drift_heading_deg(const WeatherMoment& weather, double drifting) {
  constexpr int sector_deg = 15, sectors = 24;
  if (!(weather.wind_speed_m_s > 0.0 && drifting > 0.0)) return -1;
  const double turns = std::remainder(weather.wind_heading_deg, 360.0) / sector_deg;
  return static_cast<int>(std::lround(turns) + sectors) % sectors * sector_deg;
}

}  // namespace wold::snow
