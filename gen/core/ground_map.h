#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <vector>

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

/// Terrain heights in metres above the scene's zero.
using Heightfield = GroundMap<float>;
/// Linear RGB per ground point.
using ColourMap = GroundMap<glm::vec3>;

}  // namespace wold
