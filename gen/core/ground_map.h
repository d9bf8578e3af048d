#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/parallel.h"

namespace wold {

/// A square map of the terrain: `samples` x `samples` values on the corners of a regular grid
/// that covers [0, size_m] x [0, size_m]. Value (i, j) lies at x = i*step, y = j*step (x east,
/// y north), stored with i fastest.
template <class T>
class GroundMap {
 public:
  GroundMap() = default;
  GroundMap(int samples, double size_m, T value = {})
      : samples_(samples),
        size_m_(size_m),
        values_(static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples), value) {
    if (samples < 2 || !(size_m > 0.0))
      throw std::invalid_argument(
          "a ground map needs at least 2 samples and a positive size, got " +
          std::to_string(samples) + " and " + std::to_string(size_m));
  }

  int samples() const { return samples_; }
  double size_m() const { return size_m_; }
  double step_m() const { return size_m_ / (samples_ - 1); }
  T& at(int i, int j) { return values_[index(i, j)]; }
  const T& at(int i, int j) const { return values_[index(i, j)]; }
  const std::vector<T>& values() const { return values_; }
  std::vector<T>& values() { return values_; }

  /// Bilinear value at (x_m, y_m); outside the map the border's value.
  T sample(double x_m, double y_m) const {
    const double fx = std::clamp(x_m / step_m(), 0.0, samples_ - 1.0);
    const double fy = std::clamp(y_m / step_m(), 0.0, samples_ - 1.0);
    const int i = std::min(static_cast<int>(fx), samples_ - 2);
    const int j = std::min(static_cast<int>(fy), samples_ - 2);
    const auto u = static_cast<float>(fx - i);
    const auto v = static_cast<float>(fy - j);
    return (at(i, j) * (1.0F - u) + at(i + 1, j) * u) * (1.0F - v) +
           (at(i, j + 1) * (1.0F - u) + at(i + 1, j + 1) * u) * v;
  }

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(samples_) +
           static_cast<std::size_t>(i);
  }

  int samples_ = 0;
  double size_m_ = 0.0;
  std::vector<T> values_;
};

/// Samples along a side of a map with this step, or as many as a picture should have.
inline int map_samples(double size_m, double step_m) {
  constexpr double most = 4097.0;
  return static_cast<int>(std::min(most, std::ceil(size_m / step_m - 1e-9) + 1.0));
}

/// `map` times `factor`, on the finer of the two grids. Both cover the same square.
template <class T, class Factor>
GroundMap<T> product(const GroundMap<T>& map, const GroundMap<Factor>& factor) {
  GroundMap<T> result(std::max(map.samples(), factor.samples()), map.size_m());
  parallel_for(static_cast<std::size_t>(result.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < result.samples(); ++i) {
      const double x_m = i * result.step_m();
      const double y_m = j * result.step_m();
      result.at(i, j) = map.sample(x_m, y_m) * factor.sample(x_m, y_m);
    }
  });
  return result;
}

/// Terrain heights in metres above the scene's zero.
using Heightfield = GroundMap<float>;
/// Linear RGB per ground point.
using ColourMap = GroundMap<glm::vec3>;
/// A share or factor per ground point.
using FactorMap = GroundMap<float>;

}  // namespace wold
